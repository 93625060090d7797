#include "host/compiler/outline_bytes.hpp"

#include "core/kfb_limits.hpp"
#include "core/scene_view.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::uint64_t bytes_for_segment = 24 * 128;

std::uint64_t segment_count(PackedDrawing drawing)
{
    std::uint64_t count = 0;
    for (std::uint32_t stroke = drawing.strokes(); stroke > 0; --stroke) {
        std::uint32_t segments = drawing.next_stroke();
        for (count += segments + 1; segments > 0; --segments)
            drawing.next_segment();
    }
    return count;
}

/// Of the drawing of an object that has the most.
std::uint64_t segment_count(const SceneView& scene, const ObjectView& object)
{
    std::uint64_t most = 0;
    for (KeyCursor keys = object.keys(); !keys.at_end();) {
        const Key key = keys.next();
        const std::uint64_t own = segment_count(scene.drawing(key.drawing));
        most = std::max(most, own + (object.has_arrivals ? segment_count(scene.drawing(key.arrival)) : 0));
    }
    return most;
}

/// Those of symbols counted wherever they are used.
std::uint64_t segment_count(const SceneView& scene, ItemCursor items)
{
    std::uint64_t count = 0;
    while (!items.at_end() && count * bytes_for_segment < kfb::max_outline_bytes) {
        const ItemView item = items.next();
        count += item.kind == ItemKind::object  ? 2 * segment_count(scene, item.object)
                 : item.kind == ItemKind::group ? segment_count(scene, ItemCursor{item.items})
                                                : segment_count(scene, scene.symbol(item.symbol));
    }
    return count;
}

}

std::uint32_t outline_bytes(std::span<const std::byte> file)
{
    const auto scene = SceneView::parse(file);
    const std::uint64_t bytes = segment_count(*scene, scene->items()) * bytes_for_segment;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(bytes, kfb::max_outline_bytes));
}

}
