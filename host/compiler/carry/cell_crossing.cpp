#include "host/compiler/carry/cell_crossing.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

/// A place where a segment is to be divided.
struct Crossing {
    std::uint32_t share = 0; ///< as that of Fraction
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

    /// The first share at which the border has been passed.
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

    /// Unless one of the ends is as near as no matter.
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

/// Where both cross the same borders, each is divided there; otherwise both at all places of either.
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
            divided.push_back({stretch(both.a, begin.a, end.a), stretch(both.b, begin.b, end.b)});
            begin = end;
        }
    }
    return divided;
}

}
