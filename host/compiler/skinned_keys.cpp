#include "host/compiler/skinned_keys.hpp"

#include "core/kfb_limits.hpp"
#include "host/compiler/skinned_drawing.hpp"
#include "host/compiler/time_code.hpp"

#include <algorithm>
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

std::uint32_t offset_of_skin(const SkinnedDrawing& skinned, DrawingPool& drawings)
{
    ByteWriter skin;
    skin.varint(skinned.at_rest ? 1 + drawings.offset_of(*skinned.at_rest) : 0);
    write_runs(skinned.bindings, skin);
    return drawings.offset_of(skin.bytes());
}

std::uint64_t points_of(const SkinnedDrawing& skinned)
{
    const std::uint64_t own = point_count(skinned.drawing) + 1;
    return skinned.at_rest ? 2 * own : own;
}

}

PackedKeys packed_skinned_keys(const scene::Object& object, LawTable& laws, DrawingPool& drawings,
                               Diagnostics& diagnostics)
{
    const std::vector<SkinnedDrawing> skinned = skinned_drawings(object, diagnostics);
    PackedKeys packed;
    ByteWriter bytes;
    Time before;
    for (std::size_t i = 0; i < skinned.size(); ++i) {
        const scene::Key& key = object.keys[i];
        bytes.varint(time_code(key.time - before));
        bytes.u8(laws.number_of(i + 1 == skinned.size() ? LawPair{} : key.laws, key.place));
        bytes.varint(drawings.offset_of(skinned[i].drawing));
        bytes.varint(offset_of_skin(skinned[i], drawings));
        packed.points += points_of(skinned[i]);
        before = key.time;
    }
    packed.bytes = bytes.bytes();
    return packed;
}

}
