#pragma once

#include "core/scene/scene_view.hpp"
#include "firmware/link/device.hpp"
#include "firmware/link/message.hpp"
#include "firmware/link/upload.hpp"
#include "firmware/run/blank.hpp"
#include "firmware/slots/slot_store.hpp"
#include "firmware/status.hpp"

#include <cstdint>
#include <optional>

namespace kfast::link {

/// 0 … 7: no_such_slot, or ok.
constexpr Verdict slot_exists(std::uint8_t slot)
{
    if (slot < SlotDirectory::slot_count)
        return {};
    return {Status::no_such_slot, SlotDirectory::slot_count};
}

/// The scenes that a device has, wherever they lie, and how they come to be played.
template <Device D, Flash F>
class Repertoire {
public:
    /// All of them must outlive it.
    Repertoire(D& device, const SlotStore<F>& slots, const Upload<D, F>& upload)
        : device_{device}, slots_{slots}, upload_{upload}
    {
    }

    /// Fails with no_such_slot, empty_slot, nothing_in_ram, nothing_plays, no_such_clip or an error of
    /// SceneView::parse, or as the device does; then what played plays on.
    Verdict play(const Play& what)
    {
        if (what.home == Home::start)
            return play_start_or_nothing(what.clip);
        Programme programme{.home = what.home, .slot = what.slot, .clip = what.clip};
        if (const Verdict verdict = find_scene(programme); !verdict.is_ok())
            return verdict;
        const auto scene = SceneView::parse(programme.scene, every_feature_but_outlines);
        return scene ? play(programme, *scene) : status_of(scene.error());
    }

    /// Plays what plays when the device starts: the scene of the chosen slot or, where none is chosen or it
    /// cannot be played, the built-in one. `clip` is one of its clips; empty: what the device is set to.
    /// Fails as playing the built-in scene fails, and then what played plays on.
    Verdict play_start(const Name& clip = {})
    {
        if (const auto chosen = slots_.chosen()) {
            const Verdict verdict = play_at_start({slots_.scene(*chosen), Home::slot, *chosen, clip});
            if (verdict.is_ok() || verdict.status == Status::no_such_clip)
                return verdict;
        }
        return play_at_start({device_.built_in(), Home::built_in, no_slot, clip});
    }

    /// What played plays no longer, even if there is nothing else.
    void return_to_start()
    {
        if (!play_start().is_ok())
            device_.play_nothing();
    }

private:
    /// A device that has no scene for its start plays nothing then.
    Verdict play_start_or_nothing(const Name& clip)
    {
        const Verdict verdict = play_start(clip);
        if (verdict != Verdict{Status::no_scene})
            return verdict;
        device_.play_nothing();
        return {};
    }

    Verdict play_at_start(Programme programme)
    {
        if (is_blank(programme.scene))
            return Status::no_scene;
        const auto scene = SceneView::parse(programme.scene, every_feature_but_outlines);
        if (!scene)
            return status_of(scene.error());
        const Name default_value = device_.facts().start_clip;
        if (programme.clip.view().empty() && scene->clip(default_value.view()))
            programme.clip = default_value;
        return play(programme, *scene);
    }

    Verdict play(Programme programme, const SceneView& scene)
    {
        if (!programme.clip.view().empty() && !scene.clip(programme.clip.view()))
            return Status::no_such_clip;
        programme.scene = programme.scene.first(scene.size());
        return device_.play(programme, scene);
    }

    /// Fills in where the scene lies.
    Verdict find_scene(Programme& programme) const
    {
        switch (programme.home) {
        case Home::built_in:
            programme.slot = no_slot;
            programme.scene = device_.built_in();
            return is_blank(programme.scene) ? Status::no_scene : Status::ok;
        case Home::slot:
            if (const Verdict verdict = slot_exists(programme.slot); !verdict.is_ok())
                return verdict;
            programme.scene = slots_.scene(programme.slot);
            return programme.scene.empty() ? Status::empty_slot : Status::ok;
        case Home::ram:
            programme.slot = no_slot;
            programme.scene = upload_.ram_scene();
            return programme.scene.empty() ? Status::nothing_in_ram : Status::ok;
        case Home::here:
        case Home::start:
            break;
        }
        const Playing playing = device_.playing();
        programme.home = playing.home;
        programme.slot = playing.slot;
        programme.scene = device_.played();
        return playing.is_playing ? Status::ok : Status::nothing_plays;
    }

    D& device_;
    const SlotStore<F>& slots_;
    const Upload<D, F>& upload_;
};

}
