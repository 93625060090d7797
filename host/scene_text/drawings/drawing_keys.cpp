#include "host/scene_text/drawings/drawing_keys.hpp"

#include "host/program/failure.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/values/default_pivot.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene_text/drawings/shape_text.hpp"
#include "host/scene_text/drawings/steady_form.hpp"

namespace kfast::scene_text {
namespace {

void check_points(const art::Drawing& drawing)
{
    std::size_t points = 0;
    for (const scene::Outline& outline : drawing.outlines)
        points += outline.curves.size() + 2;
    if (points > scene::max_points)
        throw Failure("a drawing has more than " + std::to_string(scene::max_points) +
                      " points, the most in a scene; divide it into several, or simplify it");
}

}

DrawingKeys drawing_keys(const art::Shape& shape, std::int32_t length)
{
    DrawingKeys keys =
        stored_keys(shape.drawing, length, [](const art::Drawing& drawing) { return on_grid(drawing); });
    std::vector<art::Drawing*> drawings;
    for (auto& key : keys) {
        check_points(key.value);
        if (shape.stroke || shape.skin)
            keep_open(key.value);
        if (!key.value.outlines.empty())
            drawings.push_back(&key.value);
    }
    if (keys.size() > 1 || shape.skin)
        keep_segments(drawings);
    return keys;
}

scene::Point default_pivot(const DrawingKeys& keys)
{
    std::vector<scene::Key> drawings(1);
    for (const auto& key : keys) {
        for (const scene::Outline& outline : key.value.outlines)
            drawings.front().drawing.strokes.push_back(quantized(outline));
        if (!key.value.outlines.empty())
            break;
    }
    scene::ItemValues values;
    scene::set_default_pivot(drawings, values);
    const auto at = [&](Property property) {
        return static_cast<std::int16_t>(values.get(property).value_or(0));
    };
    return {at(Property::pivot_x), at(Property::pivot_y)};
}

}
