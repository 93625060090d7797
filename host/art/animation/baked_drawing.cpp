#include "host/art/animation/baked_drawing.hpp"

#include <numbers>
#include <utility>

namespace kfast::art {
namespace {

using scene::Curve;
using scene::Outline;
using scene::Vec2;

/// The points of drawings of one form in one row, three for each curve.
class DrawingSpots {
public:
    explicit DrawingSpots(Drawing form) : form_{std::move(form)} {}

    Spots of(const Drawing& drawing)
    {
        Spots spots;
        for (std::size_t i = 0; i < drawing.outlines.size(); ++i)
            append(drawing.outlines[i], form_.outlines[i], spots);
        return spots;
    }

    Drawing drawing(const Spots& spots) const
    {
        Drawing drawing = form_;
        std::size_t next = 0;
        for (Outline& outline : drawing.outlines) {
            outline.from = spots.list[next++];
            for (Curve& curve : outline.curves) {
                curve.c1 = spots.list[next];
                curve.c2 = spots.list[next + 1];
                curve.to = spots.list[next + 2];
                next += 3;
            }
        }
        return drawing;
    }

private:
    static void append(const Outline& outline, Outline& form, Spots& spots)
    {
        Vec2 from = outline.from;
        spots.list.push_back(from);
        for (std::size_t i = 0; i < outline.curves.size(); ++i) {
            const Curve curve = as_cubic(from, outline.curves[i]);
            form.curves[i].cubic = form.curves[i].cubic || outline.curves[i].cubic;
            spots.list.insert(spots.list.end(), {curve.c1, curve.c2, curve.to});
            from = curve.to;
        }
    }

    Drawing form_; ///< a curve is a cubic where it has ever been one
};

/// Returns a baking with the tolerance of a coordinate instead of that of a point.
Baking for_places(Baking baking)
{
    baking.tolerance /= std::numbers::sqrt2;
    return baking;
}

Channel channel(const Animated<Spots>& baked, double Vec2::*coordinate)
{
    std::vector<Key<double>> keys;
    for (const auto& key : baked.keys)
        keys.push_back({key.time, key.value.list.front().*coordinate, key.ease});
    return Channel{std::move(keys)};
}

}

Animated<Drawing> baked_drawing(const std::function<Drawing(double)>& drawing_at, const Baking& baking)
{
    DrawingSpots spots{drawing_at(baking.from)};
    const auto baked =
        baked_spots([&](double time) { return spots.of(drawing_at(time)); }, for_places(baking));
    std::vector<Key<Drawing>> keys;
    for (const auto& key : baked.keys)
        keys.push_back({key.time, spots.drawing(key.value), key.ease});
    return Animated<Drawing>{std::move(keys)};
}

Channel baked_channel(const std::function<double(double)>& value_at, const Baking& baking)
{
    return channel(baked_spots([&](double time) { return Spots{{{value_at(time), 0}}}; }, baking), &Vec2::x);
}

PlaceChannels baked_place(const std::function<Vec2(double)>& place_at, const Baking& baking)
{
    const auto baked = baked_spots([&](double time) { return Spots{{place_at(time)}}; }, for_places(baking));
    return {channel(baked, &Vec2::x), channel(baked, &Vec2::y)};
}

}
