#include "host/compiler/carry/relative_drawing.hpp"

#include "core/scene/kfb_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kfast {

namespace {

/// A point at which a segment is to be divided.
struct Crossing {
    std::uint32_t share = 0; ///< as in Fraction
    double border = 0;       ///< along the backbones
};

/// Finds the crossings of one segment.
class CrossingSearch {
public:
    CrossingSearch(const Segment& segment, const DeformingCells& deforming)
        : segment_{segment}, deforming_{deforming}, offset_{segment.kind == Segment::Kind::cubic ? 0.5 : 0.0}
    {
    }

    std::vector<Crossing> crossings()
    {
        const std::uint32_t steps = step_count();
        for (std::uint32_t i = 0; i < steps; ++i)
            add_between(Fraction::ratio(i, steps).raw, Fraction::ratio(i + 1, steps).raw);
        return passes_node_ ? found_ : std::vector<Crossing>{};
    }

private:
    std::uint32_t step_count() const
    {
        const Vec2 from = in_pixels(segment_.from);
        const Vec2 c1 = in_pixels(segment_.c1);
        const Vec2 c2 = in_pixels(segment_.c2);
        const Vec2 to = in_pixels(segment_.to);
        const double size = segment_.kind == Segment::Kind::line
                                ? distance(from, to)
                                : distance(from, c1) + distance(c1, c2) + distance(c2, to);
        constexpr double step = 2; // px
        return static_cast<std::uint32_t>(std::clamp(std::ceil(size / step), 1.0, 256.0));
    }

    RelativePoint place_at(std::uint32_t share) const
    {
        return deforming_.cells.place_of(in_pixels(point_at(segment_, Fraction{share})), deforming_.backbone);
    }

    void add_between(std::uint32_t begin, std::uint32_t end)
    {
        const RelativePoint from = place_at(begin);
        const RelativePoint to = place_at(end);
        if (from.backbone != to.backbone)
            return;
        passes_node_ = passes_node_ || std::floor(from.along) != std::floor(to.along);
        const double low = std::min(from.along, to.along);
        std::vector<double> borders = borders_between(low, std::max(from.along, to.along), from.backbone);
        if (from.along > to.along)
            std::ranges::reverse(borders);
        for (const double border : borders)
            add({where(border, from.along < border, begin, end), border});
    }

    /// Between the first and the last node.
    std::vector<double> borders_between(double low, double high, std::int32_t backbone) const
    {
        const auto [first_node, last_node] = deforming_.cells.reach(backbone);
        std::vector<double> borders;
        const auto last = static_cast<int>(std::floor(high - offset_));
        for (int node = static_cast<int>(std::floor(low - offset_)) + 1; node <= last; ++node)
            if (const double border = node + offset_; border > first_node && border < last_node)
                borders.push_back(border);
        return borders;
    }

    /// The first fraction at which the border has been passed.
    std::uint32_t where(double border, bool begins_below, std::uint32_t begin, std::uint32_t end) const
    {
        while (end - begin > 1) {
            const std::uint32_t middle = (begin + end) / 2;
            if ((place_at(middle).along < border) == begins_below)
                begin = middle;
            else
                end = middle;
        }
        return end;
    }

    /// Adds it unless one of the ends is too near to matter.
    void add(Crossing crossing)
    {
        constexpr double near = 0.5; // px
        const Vec2 at = in_pixels(point_at(segment_, Fraction{crossing.share}));
        if (distance(at, in_pixels(segment_.from)) > near && distance(at, in_pixels(segment_.to)) > near)
            found_.push_back(crossing);
    }

    const Segment& segment_;
    const DeformingCells& deforming_;
    double offset_; ///< of the borders from the nodes
    std::vector<Crossing> found_;
    bool passes_node_ = false;
};

/// Where both sides of a pair are divided.
using FractionPairs = std::vector<Pair<Fraction>>;

FractionPairs merged(const std::vector<Crossing>& a, const std::vector<Crossing>& b)
{
    std::vector<std::uint32_t> all;
    for (const auto* crossings : {&a, &b})
        for (const Crossing& crossing : *crossings)
            all.push_back(crossing.share);
    std::ranges::sort(all);
    FractionPairs shares;
    constexpr std::uint32_t nearest = Fraction::one / 64;
    for (const std::uint32_t share : all)
        if (share >= (shares.empty() ? 0 : shares.back().a.raw) + nearest && share <= Fraction::one - nearest)
            shares.push_back({{share}, {share}});
    return shares;
}

/// Where both cross the same borders, each is divided there; otherwise both at all crossings of either.
FractionPairs shares_of(const Pair<Segment>& both, const DeformingCells& a, const DeformingCells& b)
{
    const std::vector<Crossing> of_a = CrossingSearch{both.a, a}.crossings();
    const std::vector<Crossing> of_b = CrossingSearch{both.b, b}.crossings();
    if (!std::ranges::equal(of_a, of_b, {}, &Crossing::border, &Crossing::border))
        return merged(of_a, of_b);
    FractionPairs shares;
    for (std::size_t i = 0; i < of_a.size(); ++i)
        shares.push_back({{of_a[i].share}, {of_b[i].share}});
    return shares;
}

}

SegmentPairs divided_at_cells(const SegmentPairs& stroke, const DeformingCells& a, const DeformingCells& b)
{
    SegmentPairs divided;
    for (const Pair<Segment>& both : stroke) {
        FractionPairs ends = shares_of(both, a, b);
        ends.push_back({{Fraction::one}, {Fraction::one}});
        Pair<Fraction> begin;
        for (const Pair<Fraction>& end : ends) {
            divided.push_back({subsegment(both.a, begin.a, end.a), subsegment(both.b, begin.b, end.b)});
            begin = end;
        }
    }
    return divided;
}

namespace {

RelativeStroke relative_stroke(const std::vector<Segment>& stroke, const BackboneCells& cells)
{
    const std::int32_t main = cells.main_backbone(spots_of(stroke));
    RelativeStroke relative{cells.place_of(in_pixels(stroke.front().from), main), {}};
    std::int32_t backbone = relative.from.backbone;
    for (const Segment& segment : stroke) {
        RelativeSegment& added = relative.segments.emplace_back();
        added.to = cells.place_of(in_pixels(segment.to), main);
        added.cubic = segment.kind == Segment::Kind::cubic;
        if (added.cubic) {
            added.c1 = cells.place_on(in_pixels(segment.c1), backbone);
            added.c2 = cells.place_on(in_pixels(segment.c2), added.to.backbone);
        }
        backbone = added.to.backbone;
    }
    return relative;
}

/// A point in the units that are stored.
struct Stored {
    long x;
    long y;
};

Stored stored(const RelativePoint& point, std::uint32_t unit_bits)
{
    const double unit = std::ldexp(1, static_cast<int>(unit_bits));
    return {std::min(std::lround(point.along * unit), std::lround(point.limit * unit) - 1),
            std::lround(point.across * unit)};
}

bool fits(const RelativePoint& point, std::uint32_t unit_bits)
{
    const auto fits = [](long value) { return value >= kfb::min_coordinate && value <= kfb::max_coordinate; };
    const auto [x, y] = stored(point, unit_bits);
    return fits(x) && fits(y);
}

bool fits(const RelativeStroke& stroke, std::uint32_t unit_bits)
{
    return fits(stroke.from, unit_bits) &&
           std::ranges::all_of(stroke.segments, [unit_bits](const RelativeSegment& segment) {
               return fits(segment.c1, unit_bits) && fits(segment.c2, unit_bits) &&
                      fits(segment.to, unit_bits);
           });
}

scene::Point rounded(const RelativePoint& point, std::uint32_t unit_bits)
{
    const auto [x, y] = stored(point, unit_bits);
    return {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
}

scene::Segment rounded(const RelativeSegment& segment, std::uint32_t unit_bits)
{
    if (!segment.cubic)
        return {.cubic = false, .c1 = {}, .c2 = {}, .to = rounded(segment.to, unit_bits)};
    return {true, rounded(segment.c1, unit_bits), rounded(segment.c2, unit_bits),
            rounded(segment.to, unit_bits)};
}

}

RelativeDrawing relative_drawing(const SegmentDrawing& drawing, const BackboneCells& cells)
{
    RelativeDrawing relative;
    for (const std::vector<Segment>& stroke : drawing)
        relative.push_back(relative_stroke(stroke, cells));
    return relative;
}

std::vector<Vec2> spots_of(const std::vector<Segment>& stroke)
{
    std::vector<Vec2> spots{in_pixels(stroke.front().from)};
    for (const Segment& segment : stroke)
        spots.push_back(in_pixels(segment.to));
    return spots;
}

std::uint32_t unit_bits_of(std::span<const RelativeDrawing> drawings)
{
    std::uint32_t bits = kfb::max_unit_bits;
    for (const RelativeDrawing& drawing : drawings)
        for (const RelativeStroke& stroke : drawing)
            while (bits > kfb::min_unit_bits && !fits(stroke, bits))
                --bits;
    return bits;
}

scene::Drawing rounded(const RelativeDrawing& drawing, std::uint32_t unit_bits)
{
    scene::Drawing result;
    for (const RelativeStroke& stroke : drawing) {
        scene::Stroke& added = result.strokes.emplace_back();
        added.from = rounded(stroke.from, unit_bits);
        for (const RelativeSegment& segment : stroke.segments)
            added.segments.push_back(rounded(segment, unit_bits));
    }
    return result;
}

}
