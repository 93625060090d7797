#include "host/compiler/match/corresponding_places.hpp"

#include "host/compiler/match/vertex_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

/// Moves the vertices of `a` to where they are on `b` if the pairs coincide: then more of them may be seen
/// to correspond.
void lay_onto(const StrokeVertices& b, const std::vector<Pair<std::size_t>>& pairs, StrokeVertices& a)
{
    for (std::size_t k = 0; k + 1 < pairs.size(); ++k) {
        const double begin = a.positions[pairs[k].a];
        const double end = a.positions[pairs[k + 1].a];
        const double target = b.positions[pairs[k].b];
        const double extent = b.positions[pairs[k + 1].b] - target;
        for (std::size_t i = pairs[k].a; i < pairs[k + 1].a; ++i)
            a.positions[i] = target + share_between(begin, end, a.positions[i]) * extent;
    }
    a.positions.back() = b.positions.back();
}

/// One stroke's vertices behind `at` and before `end`, as shares of the way from `begin` to `end`.
class SpanVertices {
public:
    SpanVertices(const std::vector<double>& positions, std::size_t begin, std::size_t end)
        : positions_{positions}, begin_{begin}, end_{end}, at_{begin}
    {
    }

    bool is_at_end() const { return at_ + 1 == end_; }

    /// Of the next vertex; 1 at the end.
    double next_share() const
    {
        return is_at_end() ? 1 : share_between(positions_[begin_], positions_[end_], positions_[at_ + 1]);
    }

    StrokePlace next() { return {++at_, 0}; }

    /// A place before the next vertex.
    StrokePlace at_share(double share) const
    {
        const double position = positions_[begin_] + share * (positions_[end_] - positions_[begin_]);
        return {at_, share_between(positions_[at_], positions_[at_ + 1], position)};
    }

private:
    const std::vector<double>& positions_;
    std::size_t begin_;
    std::size_t end_;
    std::size_t at_;
};

void add_places(SpanVertices a, SpanVertices b, CorrespondingPlaces& places)
{
    constexpr double same = 1e-9;
    while (!a.is_at_end() || !b.is_at_end()) {
        const Pair<double> next{a.next_share(), b.next_share()};
        const bool both = !a.is_at_end() && !b.is_at_end() && std::abs(next.a - next.b) < same;
        const bool from_a = both || b.is_at_end() || (!a.is_at_end() && next.a < next.b);
        const bool from_b = both || !from_a;
        places.a.push_back(from_a ? a.next() : a.at_share(next.b));
        places.b.push_back(from_b ? b.next() : b.at_share(next.a));
    }
}

}

CorrespondingPlaces corresponding_places(const AlignedStrokes& strokes)
{
    StrokeVertices a = vertices_of(strokes.a);
    StrokeVertices b = vertices_of(strokes.b);
    for (double& position : b.positions)
        position += strokes.offset;
    lay_onto(b, vertex_pairs(a, b), a);
    const std::vector<Pair<std::size_t>> pairs = vertex_pairs(a, b);

    CorrespondingPlaces places{{{0, 0}}, {{0, 0}}};
    for (std::size_t i = 0; i + 1 < pairs.size(); ++i) {
        add_places({a.positions, pairs[i].a, pairs[i + 1].a}, {b.positions, pairs[i].b, pairs[i + 1].b},
                   places);
        places.a.push_back({pairs[i + 1].a, 0});
        places.b.push_back({pairs[i + 1].b, 0});
    }
    return places;
}

}
