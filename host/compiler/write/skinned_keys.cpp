#include "host/compiler/write/skinned_keys.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/compiler/carry/skinned_drawing.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/compiler/pack/value_writer.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace kfast {
namespace {

const scene::Drawing& first_seen(const std::vector<scene::Key>& keys)
{
    const auto is_seen = [](const scene::Key& key) { return !key.drawing.strokes.empty(); };
    const auto first = std::ranges::find_if(keys, is_seen);
    return first == keys.end() ? keys.front().drawing : first->drawing;
}

std::vector<SkinnedDrawing> skinned_drawings(const scene::Object& object, Diagnostics& diagnostics)
{
    const scene::Drawing& first = first_seen(object.keys);
    std::vector<SkinnedDrawing> drawings;
    for (const scene::Key& key : object.keys) {
        auto skinned = skinned_drawing(first, object.skin->bindings, key.drawing);
        if (!skinned)
            diagnostics.error(key.place,
                              "to follow bones as the first drawing does, this one takes more than " +
                                  std::to_string(kfb::max_drawing_points) +
                                  " points, as many as a drawing holds",
                              "draw both with fewer points");
        else if (object.skin->turns_changes)
            skinned->at_rest.reset();
        drawings.push_back(std::move(skinned).value_or(SkinnedDrawing{}));
    }
    return drawings;
}

/// Points in a row that follow the same bones are stored as one run.
void write_runs(const std::vector<scene::Binding>& bindings, ByteWriter& bytes)
{
    for (auto run = bindings.begin(); run != bindings.end();) {
        const auto end = std::find_if(run, bindings.end(),
                                      [run](const scene::Binding& binding) { return binding != *run; });
        const auto points = static_cast<std::uint32_t>(end - run);
        bytes.varint(4 * (points - 1) + static_cast<std::uint32_t>(run->size()) - 1);
        for (const scene::BoneWeight& share : *run) {
            bytes.u8(static_cast<std::uint32_t>(share.bone));
            if (&share != &run->back())
                bytes.u8(static_cast<std::uint32_t>(share.weight));
        }
        run = end;
    }
}

/// The one that carries all points, which are at rest where they are drawn.
std::optional<std::int32_t> only_bone(const SkinnedDrawing& skinned)
{
    const auto is_first = [&skinned](const scene::Binding& binding) {
        return binding.size() == 1 && binding == skinned.bindings.front();
    };
    if (skinned.at_rest || skinned.bindings.empty() || !std::ranges::all_of(skinned.bindings, is_first))
        return std::nullopt;
    return static_cast<std::int32_t>(skinned.bindings.front().front().bone);
}

/// The number by which a key refers to it.
std::int32_t number_of_skin(const SkinnedDrawing& skinned, DrawingPool& drawings)
{
    if (const auto bone = only_bone(skinned))
        return -1 - *bone;
    ByteWriter skin;
    skin.varint(skinned.at_rest ? 1 + static_cast<std::uint32_t>(drawings.offset_of(*skinned.at_rest)) : 0);
    write_runs(skinned.bindings, skin);
    return drawings.offset_of(skin.bytes());
}

}

PackedKeys packed_skinned_keys(const scene::Object& object, LawTable& laws, DrawingPool& drawings,
                               Diagnostics& diagnostics)
{
    const std::vector<SkinnedDrawing> skinned = skinned_drawings(object, diagnostics);
    PackedKeys packed;
    KeyTimes key_times;
    std::vector<std::int32_t> offsets;
    std::vector<std::int32_t> skins;
    for (std::size_t i = 0; i < skinned.size(); ++i) {
        const scene::Key& key = object.keys[i];
        key_times.push_back(
            {key.time, laws.number_of(i + 1 == skinned.size() ? LawPair{} : key.laws, key.place)});
        offsets.push_back(drawings.offset_of(skinned[i].drawing));
        skins.push_back(number_of_skin(skinned[i], drawings));
    }
    ByteWriter bytes;
    write_key_times({key_times, object.driver}, one_key_time, bytes);
    write_values(offsets, bytes);
    write_values(skins, bytes);
    packed.bytes = bytes.bytes();
    return packed;
}

}
