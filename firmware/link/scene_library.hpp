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

/// Returns no_such_slot, or ok for 0 … 7.
constexpr StatusWithNumber slot_exists(std::uint8_t slot)
{
    if (slot < SlotDirectory::slot_count)
        return {};
    return {Status::no_such_slot, SlotDirectory::slot_count};
}

/// The scenes that a device has, wherever they are, and how they come to be played.
template <Device D, Flash F>
class SceneLibrary {
public:
    /// All of them must outlive it.
    SceneLibrary(D& device, SlotStore<F>& slots, const Upload<D, F>& upload)
        : device_{device}, slots_{slots}, upload_{upload}
    {
    }

    /// Fails with no_such_slot, empty_slot, nothing_in_ram, nothing_plays, no_such_clip, bad_checksum if a
    /// slot holds something else than was put into it, or an error of SceneView::parse, or as the device
    /// does; then the scene that played plays on.
    StatusWithNumber play(const Play& what)
    {
        if (what.home == Home::start)
            return play_start_or_nothing(what.clip);
        SceneSelection selection{.home = what.home, .slot = what.slot, .clip = what.clip};
        if (const StatusWithNumber result = find_scene(selection); !result.is_ok())
            return result;
        const auto scene = SceneView::parse(selection.scene, every_feature_but_outlines);
        return scene ? play(selection, *scene) : status_of(scene.error());
    }

    /// Plays what plays when the device starts: the scene of the chosen slot or, where none is chosen, it
    /// cannot be played or the device is in safe mode (Restarts), the built-in one. `clip` is one of its
    /// clips; empty: what the device is set to. Fails as playing the built-in scene fails, or with no_scene
    /// if safe mode does not allow that either, and then the scene that played plays on.
    StatusWithNumber play_start(const Name& clip = {})
    {
        const Restarts restarts = heeded_restarts();
        if (!restarts.allows_built_in())
            return Status::no_scene;
        const auto chosen = slots_.chosen();
        if (chosen && !restarts.is_safe_mode() && slots_.is_whole(*chosen)) {
            const StatusWithNumber result = play_at_start({slots_.scene(*chosen), Home::slot, *chosen, clip});
            if (result.is_ok() || result.status == Status::no_such_clip)
                return result;
        }
        return play_at_start({device_.built_in(), Home::built_in, no_slot, clip});
    }

    /// From now on the scene of `slot` plays at the start, no_slot: the built-in one; safe mode does not
    /// contradict. Fails with no_such_slot, or as the slots do.
    StatusWithNumber choose(std::uint8_t slot)
    {
        const bool is_slot = slot != no_slot;
        if (const StatusWithNumber result = slot_exists(slot); is_slot && !result.is_ok())
            return result;
        const Status status = slots_.choose(is_slot ? std::optional{slot} : std::nullopt);
        heeds_choice_ = heeds_choice_ || status == Status::ok;
        return status;
    }

    /// Ends what played, even if there is nothing else.
    void return_to_start()
    {
        if (!play_start().is_ok())
            device_.play_nothing();
    }

private:
    Restarts heeded_restarts() const { return heeds_choice_ ? Restarts{} : device_.facts().restarts; }

    /// A device that has no scene for its start plays nothing then.
    StatusWithNumber play_start_or_nothing(const Name& clip)
    {
        const StatusWithNumber result = play_start(clip);
        if (result != StatusWithNumber{Status::no_scene})
            return result;
        device_.play_nothing();
        return {};
    }

    StatusWithNumber play_at_start(SceneSelection selection)
    {
        if (is_blank(selection.scene))
            return Status::no_scene;
        const auto scene = SceneView::parse(selection.scene, every_feature_but_outlines);
        if (!scene)
            return status_of(scene.error());
        const Name start_clip = device_.facts().start_clip;
        if (selection.clip.view().empty() && scene->clip(start_clip.view()))
            selection.clip = start_clip;
        return play(selection, *scene);
    }

    StatusWithNumber play(SceneSelection selection, const SceneView& scene)
    {
        if (!selection.clip.view().empty() && !scene.clip(selection.clip.view()))
            return Status::no_such_clip;
        selection.scene = selection.scene.first(scene.size());
        return device_.play(selection, scene);
    }

    /// Sets where the scene is.
    StatusWithNumber find_scene(SceneSelection& selection) const
    {
        switch (selection.home) {
        case Home::built_in:
            selection.slot = no_slot;
            selection.scene = device_.built_in();
            return is_blank(selection.scene) ? Status::no_scene : Status::ok;
        case Home::slot:
            return find_scene_of_slot(selection);
        case Home::ram:
            selection.slot = no_slot;
            selection.scene = upload_.ram_scene();
            return selection.scene.empty() ? Status::nothing_in_ram : Status::ok;
        case Home::here:
        case Home::start:
            break;
        }
        const Playing playing = device_.playing();
        selection.home = playing.home;
        selection.slot = playing.slot;
        selection.scene = device_.played();
        return playing.is_playing ? Status::ok : Status::nothing_plays;
    }

    StatusWithNumber find_scene_of_slot(SceneSelection& selection) const
    {
        if (const StatusWithNumber result = slot_exists(selection.slot); !result.is_ok())
            return result;
        selection.scene = slots_.scene(selection.slot);
        if (selection.scene.empty())
            return Status::empty_slot;
        return slots_.is_whole(selection.slot) ? Status::ok : Status::bad_checksum;
    }

    D& device_;
    SlotStore<F>& slots_;
    const Upload<D, F>& upload_;
    bool heeds_choice_ = false; ///< somebody has chosen since the start
};

}
