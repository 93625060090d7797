#include "host/lottie/values/channel.hpp"

#include "host/art/animation/baked_drawing.hpp"
#include "host/lottie/values/json.hpp"
#include "host/lottie/values/ways.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace kfast::lottie {

namespace {

bool counts_to_255(const Json& colour)
{
    return colour.is_array() && std::any_of(colour.begin(), colour.end(), [](const Json& channel) {
               return channel.is_number() && channel.get<double>() > 1;
           });
}

/// The first versions of the format counted channels to 255.
double channel_unit(const Property& property)
{
    const bool bytes = property.value ? counts_to_255(*property.value)
                                      : std::ranges::any_of(property.keys, [](const FileKey& key) {
                                            return counts_to_255(*key.begin);
                                        });
    return bytes ? 1.0 / 255 : 1;
}

art::Rgb colour_of(const Json& value, double unit)
{
    const auto channel = [&](std::size_t index) {
        return std::clamp(component(value, index, 0) * unit, 0.0, 1.0);
    };
    if (!value.is_array())
        throw WrongMember(value, "is no colour: one is a list of red, green and blue");
    return {channel(0), channel(1), channel(2)};
}

}

art::Channel read_channel(const Json& owner, const char* name, std::size_t index, double default_value,
                          double factor, const LayerTime& time, art::Budget& budget)
{
    const auto value_of = [&](const Json& value) {
        return component(value, index, default_value / factor) * factor;
    };
    return read_animated<double>(read_property(owner, name), index, value_of, time, budget)
        .value_or(art::Channel{default_value});
}

art::Animated<art::Rgb> read_colour(const Json& owner, const char* name, const LayerTime& time,
                                    art::Budget& budget)
{
    const Property property = read_property(owner, name);
    const double unit = channel_unit(property);
    const auto value_of = [&](const Json& value) { return colour_of(value, unit); };
    return read_animated<art::Rgb>(property, 0, value_of, time, budget).value_or(art::Rgb{});
}

art::Channel combined(const std::function<double(double)>& value_at,
                      std::initializer_list<const art::Channel*> channels, Dependence dependence,
                      double tolerance, art::Budget& budget)
{
    std::vector<const art::Channel*> moving;
    std::ranges::copy_if(channels, std::back_inserter(moving),
                         [](const art::Channel* channel) { return !channel->is_still(); });
    if (moving.empty())
        return {value_at(0)};
    if (dependence == Dependence::linear && moving.size() == 1) {
        art::Channel result = *moving.front();
        for (auto& key : result.keys)
            key.value = value_at(key.time);
        return result;
    }
    art::Baking baking;
    baking.from = moving.front()->keys.front().time;
    baking.to = baking.from;
    baking.tolerance = tolerance;
    for (const art::Channel* channel : moving)
        for (const auto& key : channel->keys) {
            baking.from = std::min(baking.from, key.time);
            baking.to = std::max(baking.to, key.time);
            baking.critical.push_back(key.time);
        }
    constexpr double asked_each_frame = 4;
    constexpr double max_asked = 1 << 27;
    budget.take_computed_points(
        static_cast<std::size_t>(std::min(asked_each_frame * (baking.to - baking.from), max_asked)));
    return art::baked_channel(value_at, baking);
}

namespace {

using scene::Vec2;

Vec2 spot_of(const Json& value)
{
    if (!value.is_array() || value.size() < 2)
        throw WrongMember(value, "is no point: one is a list of x and y");
    return {number_of(value[0]), number_of(value[1])};
}

/// Tangents that are missing have no length.
Vec2 tangent_of(const Json* tangents, std::size_t index)
{
    return tangents && tangents->is_array() && index < tangents->size() ? spot_of((*tangents)[index])
                                                                        : Vec2{};
}

bool is_zero(Vec2 spot) { return spot.x == 0 && spot.y == 0; }

/// In keys, paths are in a list of one.
const Json& path_itself(const Json& value)
{
    const Json& path = value.is_array() && !value.empty() ? value.front() : value;
    if (!path.is_object())
        throw WrongMember(value, "is no path: one is an object with \"v\", \"i\" and \"o\"");
    return path;
}

/// The drawing, all cubics. In files before version 4.4.18 the shape says whether it is closed.
art::Drawing drawing_of(const Json& value, bool usually_closed, art::Budget& budget)
{
    const Json& path = path_itself(value);
    const Json& vertices = array_at(path, "v");
    budget.take_points(vertices.size());
    if (vertices.empty())
        return {};
    const Json* const in = find_member(path, "i");
    const Json* const out = find_member(path, "o");
    scene::Outline outline{spot_of(vertices[0]), {}, truth_at(path, "c", usually_closed)};
    Vec2 from = outline.from;
    const std::size_t count = vertices.size();
    for (std::size_t i = 1; i < count + (outline.closed ? 1 : 0); ++i) {
        const Vec2 to = spot_of(vertices[i % count]);
        outline.curves.push_back(
            scene::cubic_to(from + tangent_of(out, i - 1), to + tangent_of(in, i % count), to));
        from = to;
    }
    return {{std::move(outline)}};
}

bool is_straight(const art::Drawing& drawing, std::size_t index)
{
    const scene::Outline& outline = drawing.outlines.front();
    const scene::Curve& curve = outline.curves[index];
    const Vec2 from = index == 0 ? outline.from : outline.curves[index - 1].to;
    return is_zero(curve.c1 - from) && is_zero(curve.c2 - curve.to);
}

/// Makes lines of straight cubics. Between a line and a curve, tangents grow from 0: both stay cubic.
void straighten(art::Animated<art::Drawing>& drawings)
{
    std::size_t max = 0;
    for (const auto& key : drawings.keys)
        if (!key.value.outlines.empty())
            max = std::max(max, key.value.outlines.front().curves.size());
    const auto has = [](const art::Drawing& drawing, std::size_t index) {
        return !drawing.outlines.empty() && index < drawing.outlines.front().curves.size();
    };
    for (std::size_t i = 0; i < max; ++i)
        if (std::ranges::all_of(drawings.keys, [&](const auto& key) {
                return !has(key.value, i) || is_straight(key.value, i);
            }))
            for (auto& key : drawings.keys)
                if (has(key.value, i))
                    key.value.outlines.front().curves[i].cubic = false;
}

}

art::Animated<art::Drawing> read_path(const Json& owner, const char* name, const LayerTime& time,
                                      art::Budget& budget)
{
    const bool closed = truth_at(owner, "closed", false);
    const auto value_of = [&](const Json& value) { return drawing_of(value, closed, budget); };
    auto drawings = read_animated<art::Drawing>(read_property(owner, name), 0, value_of, time, budget)
                        .value_or(art::Drawing{});
    straighten(drawings);
    return drawings;
}

}
