#include "host/scene_text/drawings/stored_drawings.hpp"

#include "host/program/failure.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene_text/drawings/steady_form.hpp"
#include "host/scene_text/values/grid.hpp"

#include <utility>

namespace kfast::scene_text {

namespace {

using scene::Curve;
using scene::Outline;
using scene::Vec2;

constexpr std::size_t widest_data = 96;

Vec2 snapped(Vec2 spot) { return {snapped(spot.x, coordinates), snapped(spot.y, coordinates)}; }

Outline snapped(const Outline& outline)
{
    Outline result{snapped(outline.from), {}, outline.closed};
    result.curves.reserve(outline.curves.size());
    for (const Curve& curve : outline.curves)
        result.curves.push_back(curve.cubic
                                    ? scene::cubic_to(snapped(curve.c1), snapped(curve.c2), snapped(curve.to))
                                    : scene::line_to(snapped(curve.to)));
    return result;
}

bool equal(Vec2 left, Vec2 right) { return left.x == right.x && left.y == right.y; }

class PathData {
public:
    void add(char command) { append(std::string{command}); }

    void add(char command, std::initializer_list<Vec2> spots)
    {
        std::string words{command};
        for (const Vec2 spot : spots)
            for (const double coordinate : {spot.x, spot.y})
                words += ' ' + decimal(on_grid(coordinate, coordinates), coordinates);
        append(words);
    }

    std::string take() { return std::move(data_); }

private:
    void append(const std::string& words)
    {
        if (!data_.empty() && data_.size() - line_ + 1 + words.size() > widest_data) {
            data_ += '\n';
            line_ = data_.size();
        } else if (!data_.empty()) {
            data_ += ' ';
        }
        data_ += words;
    }

    std::string data_;
    std::size_t line_ = 0; ///< where the last line begins
};

/// The command that closes a path draws a line as well.
bool closes_by_itself(const Outline& outline, const Curve& curve)
{
    return outline.closed && !curve.cubic && &curve == &outline.curves.back() && outline.curves.size() > 1 &&
           equal(curve.to, outline.from);
}

}

art::Drawing on_grid(const art::Drawing& drawing)
{
    art::Drawing result;
    result.outlines.reserve(drawing.outlines.size());
    for (const Outline& outline : drawing.outlines)
        result.outlines.push_back(snapped(outline));
    return result;
}

std::string path_data(const Outline& outline)
{
    PathData data;
    data.add('M', {outline.from});
    for (const Curve& curve : outline.curves)
        if (curve.cubic)
            data.add('C', {curve.c1, curve.c2, curve.to});
        else if (!closes_by_itself(outline, curve))
            data.add('L', {curve.to});
    if (outline.closed || outline.curves.empty())
        data.add('Z');
    return data.take();
}

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
