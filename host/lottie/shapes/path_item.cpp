#include "host/lottie/shapes/shapes.hpp"

#include "host/art/animation/baked_drawing.hpp"
#include "host/art/document/document.hpp"
#include "host/geometry/shape.hpp"
#include "host/lottie/drawings/carried.hpp"
#include "host/lottie/drawings/polystar.hpp"
#include "host/lottie/shapes/transform.hpp"
#include "host/lottie/values/json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace kfast::lottie {
namespace {

using art::Channel;
using scene::Outline;
using scene::Vec2;

/// Of "d".
constexpr int counterclockwise = 3;

Channel channel(const Json& item, const char* name, std::size_t index, double factor, const Reading& reading)
{
    return read_channel(item, name, index, 0, factor, reading.time, reading.budget);
}

/// The outline from the same point in the opposite direction.
Outline reversed(const Outline& outline)
{
    Outline result{outline.from, {}, outline.closed};
    for (std::size_t i = outline.curves.size(); i-- > 0;) {
        scene::Curve curve = outline.curves[i];
        std::swap(curve.c1, curve.c2);
        curve.to = i > 0 ? outline.curves[i - 1].to : outline.from;
        result.curves.push_back(curve);
    }
    return result;
}

MovingDrawing moving(std::initializer_list<const Channel*> channels,
                     std::function<Outline(double)> outline_at)
{
    MovingDrawing drawing;
    for (const Channel* number : channels)
        drawing.moments.add(*number);
    drawing.points = 10;
    drawing.cost = drawing.points;
    drawing.at = [outline_at = std::move(outline_at)](double time) {
        return art::Drawing{{outline_at(time)}};
    };
    return drawing;
}

/// Whether it goes from one end to the other without a bend or turning back, so that its length says where.
bool is_straight(Vec2 from, const scene::Curve& curve)
{
    const Vec2 way = curve.to - from;
    const auto lies_on_way = [&](Vec2 spot) {
        const double along = dot(way, spot - from);
        return cross(way, spot - from) == 0 && along >= 0 && along <= dot(way, way);
    };
    return !curve.cubic || (lies_on_way(curve.c1) && lies_on_way(curve.c2));
}

bool is_straight(const Outline& path)
{
    Vec2 from = path.from;
    return std::ranges::all_of(path.curves, [&](const scene::Curve& curve) {
        return is_straight(std::exchange(from, curve.to), curve);
    });
}

/// The position "p"; along its tangents, where it has them.
art::PlaceChannels read_place(const Json& item, const Reading& reading)
{
    art::Transform transform;
    read_position(transform, item, reading, false);
    if (!transform.path)
        return {transform.x, transform.y};
    if (is_straight(transform.path->path.outlines.front()))
        return {channel(item, "p", 0, 1, reading), channel(item, "p", 1, 1, reading)};
    const auto& keys = transform.path->share.keys;
    art::Baking baking{
        .from = keys.front().time, .to = keys.back().time, .critical = {}, .tolerance = baked_tolerance};
    for (const auto& key : keys)
        baking.critical.push_back(key.time);
    return art::baked_place(
        [&](double time) {
            const art::Affine affine = art::matrix_at(transform, time);
            return Vec2{affine.e, affine.f};
        },
        baking);
}

/// The middle and the size of a rectangle or an ellipse.
struct Box {
    Channel x;
    Channel y;
    Channel width;
    Channel height;
};

Box read_box(const Json& item, const Reading& reading)
{
    auto [x, y] = read_place(item, reading);
    return {std::move(x), std::move(y), channel(item, "s", 0, 1, reading), channel(item, "s", 1, 1, reading)};
}

/// An ellipse that begins at twelve o'clock instead of three.
Outline ellipse_from_top(Vec2 centre, double radius_x, double radius_y)
{
    Outline outline = scene::ellipse(centre, radius_x, radius_y);
    outline.from = outline.curves[2].to;
    std::rotate(outline.curves.begin(), outline.curves.begin() + 3, outline.curves.end());
    return outline;
}

void read_ellipse(PathItem& result, const Json& item, bool is_reversed, const Reading& reading)
{
    const Box box = read_box(item, reading);
    const auto drawn = [&](auto shape) {
        return moving({&box.x, &box.y, &box.width, &box.height}, [=](double time) {
            const Outline outline = shape({box.x.at(time), box.y.at(time)}, std::abs(box.width.at(time)) / 2,
                                          std::abs(box.height.at(time)) / 2);
            return is_reversed ? reversed(outline) : outline;
        });
    };
    result.drawing = drawn(ellipse_from_top);
    result.plain = drawn(scene::ellipse);
}

struct Rectangle {
    Vec2 centre;
    double width = 0;
    double height = 0;
    double corner = 0;
};

Rectangle rectangle_at(const Box& box, const Channel& corner, double time)
{
    const double width = std::abs(box.width.at(time));
    const double height = std::abs(box.height.at(time));
    return {{box.x.at(time), box.y.at(time)},
            width,
            height,
            std::clamp(corner.at(time), 0.0, std::min(width, height) / 2)};
}

/// A rectangle that is ever round always has arcs, so that it keeps its form.
Outline outline_of(const Rectangle& rectangle, bool is_round)
{
    constexpr double hardly_round = 1e-9;
    const Vec2 half{rectangle.width / 2, rectangle.height / 2};
    return scene::rectangle(rectangle.centre - half, rectangle.width, rectangle.height,
                            is_round ? std::max(rectangle.corner, hardly_round) : 0);
}

/// Begins where Lottie's do: at the upper right corner, after its arc.
Outline outline_from_right(const Rectangle& rectangle, bool is_round)
{
    Outline outline = outline_of(rectangle, is_round);
    if (is_round) {
        outline.from = outline.curves[1].to;
        std::rotate(outline.curves.begin(), outline.curves.begin() + 2, outline.curves.end());
        return outline;
    }
    outline.curves.push_back(scene::line_to(outline.from));
    outline.from = outline.curves[0].to;
    std::rotate(outline.curves.begin(), outline.curves.begin() + 1, outline.curves.end());
    return outline;
}

void read_rectangle(PathItem& result, const Json& item, bool is_reversed, const Reading& reading)
{
    const Box box = read_box(item, reading);
    const Channel corner = channel(item, "r", 0, 1, reading);
    const bool is_round = !corner.is_still() || corner.value() > 0;
    const auto drawn = [&](auto shape) {
        return moving({&box.x, &box.y, &box.width, &box.height, &corner}, [=](double time) {
            const Outline outline = shape(rectangle_at(box, corner, time), is_round);
            return is_reversed ? reversed(outline) : outline;
        });
    };
    result.drawing = drawn(outline_from_right);
    if (!is_reversed)
        result.plain = drawn(outline_of);
}

struct StarChannels {
    Channel x;
    Channel y;
    Channel tips;
    Channel rotation;
    Channel outer;
    Channel outer_roundness;
    Channel inner;
    Channel inner_roundness;
    bool has_inner = true;
    bool is_reversed = false;

    bool is_round() const
    {
        return outer_roundness != Channel{0} || (has_inner && inner_roundness != Channel{0});
    }
};

constexpr double max_tips = 1000;

Outline star_at(const StarChannels& star, double time)
{
    const double tips = std::floor(std::clamp(star.tips.at(time), 0.0, max_tips) + 1e-9);
    Polystar now{{star.x.at(time), star.y.at(time)},
                 static_cast<int>(tips),
                 {star.outer.at(time), star.outer_roundness.at(time)},
                 {},
                 star.rotation.at(time),
                 star.is_reversed};
    if (star.has_inner)
        now.inner = Ring{star.inner.at(time), star.inner_roundness.at(time)};
    return now.tips > 0 ? outline_of(now, star.is_round()) : Outline{now.centre, {}, true};
}

void report_tips(const StarChannels& star, const Reading& reading)
{
    if (std::ranges::any_of(star.tips.keys, [](const auto& key) { return key.value > max_tips; }))
        reading.losses.add({"star of more than 1000 points", reading.layer, std::nullopt, "a star of 1000"});
}

void read_star(PathItem& result, const Json& item, bool is_reversed, const Reading& reading)
{
    constexpr int polygon = 2;
    const art::PlaceChannels place = read_place(item, reading);
    const StarChannels star{place.x,
                            place.y,
                            channel(item, "pt", 0, 1, reading),
                            channel(item, "r", 0, 1, reading),
                            channel(item, "or", 0, 1, reading),
                            channel(item, "os", 0, 0.01, reading),
                            channel(item, "ir", 0, 1, reading),
                            channel(item, "is", 0, 0.01, reading),
                            whole_at(item, "sy", 1) != polygon,
                            is_reversed};
    report_tips(star, reading);
    result.drawing = moving({&star.x, &star.y, &star.tips, &star.rotation, &star.outer, &star.outer_roundness,
                             &star.inner, &star.inner_roundness},
                            [star](double time) { return star_at(star, time); });
    result.drawing.changes_form = !star.tips.is_still();
    for (const auto& key : star.tips.keys)
        result.drawing.points = std::max(result.drawing.points, 4 * std::min(key.value, max_tips));
    result.drawing.cost = result.drawing.points;
}

void read_own_path(PathItem& result, const Json& item, bool, const Reading& reading)
{
    result.drawing = lottie::moving(read_path(item, "ks", reading.time, reading.budget));
}

struct PathType {
    std::string_view name;
    void (*read)(PathItem&, const Json&, bool is_reversed, const Reading&);
};

constexpr std::array path_types{PathType{"sh", read_own_path}, PathType{"rc", read_rectangle},
                                PathType{"el", read_ellipse}, PathType{"sr", read_star}};

const PathType* find_path_type(std::string_view name)
{
    const auto type = std::ranges::find(path_types, name, &PathType::name);
    return type == path_types.end() ? nullptr : &*type;
}

}

bool is_path(std::string_view type) { return find_path_type(type) != nullptr; }

PathItem read_path_item(const Json& item, const Reading& reading)
{
    PathItem result;
    result.name = text_at(item, "nm");
    find_path_type(text_at(item, "ty"))
        ->read(result, item, whole_at(item, "d", 1) == counterclockwise, reading);
    return result;
}

}
