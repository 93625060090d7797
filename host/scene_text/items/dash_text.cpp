#include "host/scene_text/items/dash_text.hpp"

#include "core/scene/property.hpp"
#include "host/art/animation/baked_spots.hpp"
#include "host/art/geometry/curves.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/sums.hpp"

#include <algorithm>
#include <cstddef>

namespace kfast::scene_text {
namespace {

using art::Channel;
using art::Spots;

/// That is what lengths are rounded to.
constexpr double tolerance = 1.0 / dash_pixel;

/// Each length is the x of a spot.
class Lengths {
public:
    Lengths(const std::vector<Channel>& lengths, const Writing& writing)
        : lengths_{lengths}, writing_{writing}
    {
        for (const Channel& length : lengths)
            if (stored_keys(length, writing.length, dash_lengths).size() > 1)
                moving_.push_back(&length);
    }

    art::Animated<Spots> keys() const
    {
        if (moving_.empty())
            return at(0);
        const Channel& first = *moving_.front();
        const auto goes_alike = [&](const Channel* other) { return go_alike(first, *other); };
        if (!std::ranges::all_of(moving_, goes_alike))
            return art::baked_spots([this](double time) { return at(time); }, baking());
        std::vector<art::Key<Spots>> keys;
        for (const auto& key : first.keys)
            keys.push_back({key.time, at(key.time), key.ease});
        return art::Animated<Spots>{std::move(keys)};
    }

private:
    Spots at(double time) const
    {
        writing_.budget.take_computed_points(lengths_.size());
        Spots spots;
        for (const Channel& length : lengths_)
            spots.list.push_back({length.at(time), 0});
        return spots;
    }

    /// Within the scene.
    art::Baking baking() const
    {
        art::Baking baking;
        baking.to = off_grid(writing_.length, times);
        baking.tolerance = tolerance;
        for (const Channel* channel : moving_)
            for (const auto& key : channel->keys)
                baking.critical.push_back(key.time);
        return baking;
    }

    const std::vector<Channel>& lengths_;
    const Writing& writing_;
    std::vector<const Channel*> moving_ = {};
};

/// What dashes are counted of.
struct Extent {
    double length = 0; ///< pixels
    double outlines = 0;
};

Extent extent_of(const art::Drawing& drawing)
{
    Extent extent;
    for (const scene::Outline& outline : drawing.outlines) {
        ++extent.outlines;
        extent.length += art::outline_length(outline);
        if (outline.closed && !outline.curves.empty())
            extent.length += scene::distance(outline.curves.back().to, outline.from);
    }
    return extent;
}

/// The most of each that any of the drawings has.
Extent extent_of(const art::Animated<art::Drawing>& drawing)
{
    Extent most;
    for (const auto& key : drawing.keys) {
        const Extent extent = extent_of(key.value);
        most.length = std::max(most.length, extent.length);
        most.outlines = std::max(most.outlines, extent.outlines);
    }
    return most;
}

/// As the scene counts them: of each stroke what is cut off at its ends is a dash of its own.
bool are_drawn(const Spots& lengths, const Extent& extent)
{
    const std::size_t count = lengths.list.size();
    const double repeats = count % 2 == 0 ? 1 : 2;
    double period = 0;
    for (const scene::Vec2 length : lengths.list)
        period += repeats * snapped(length.x, dash_lengths);
    const double dashes = repeats * static_cast<double>(count) / 2;
    return (extent.length / period + 2 * extent.outlines) * dashes <= max_dash_count;
}

Spots whole_line(std::size_t count) { return {std::vector<scene::Vec2>(count)}; }

std::string text_of(const Spots& lengths)
{
    std::string text;
    for (const scene::Vec2 length : lengths.list)
        text += (text.empty() ? "" : " ") + decimal(on_grid(length.x, dash_lengths), dash_lengths);
    return text;
}

}

DashKeys dash_keys(const art::Shape& shape, const Writing& writing)
{
    const art::Animated<Spots> keys = Lengths{shape.stroke->dashes.lengths, writing}.keys();
    if (keys.is_still())
        return stored_keys(keys, writing.length, text_of);
    const Extent extent = extent_of(shape.drawing);
    return stored_keys(keys, writing.length, [&](const Spots& lengths) {
        return text_of(are_drawn(lengths, extent) ? lengths : whole_line(lengths.list.size()));
    });
}

}
