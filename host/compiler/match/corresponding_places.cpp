#include "host/compiler/match/corresponding_places.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kfast {

namespace {

/// Fraction of the length of the stroke: a vertex that is moved so little along it does not visibly move.
constexpr double unseen = 0.02;
/// Only that many vertices on either side of the nearest are tried.
constexpr std::ptrdiff_t max_tried = 8;

Vec2 unit(Vec2 direction)
{
    const double length = std::sqrt(dot(direction, direction));
    return length > 0 ? (1 / length) * direction : Vec2{};
}

StrokeCorner corner_between(const MeasuredSegment& before, const MeasuredSegment& after)
{
    constexpr double cosine = 0.8660254037844386; // of 30 degrees
    const Vec2 in = -1.0 * unit(direction(reversed(before)));
    const Vec2 out = unit(direction(after));
    return dot(in, out) < cosine ? StrokeCorner{in, out} : StrokeCorner{};
}

/// 1 for corners that point the same way, 0 for those at right angles and for vertices that are no corners.
double likeness(const StrokeCorner& a, const StrokeCorner& b)
{
    return std::max(0.0, (dot(a.in, b.in) + dot(a.out, b.out)) / 2);
}

/// Half of the distance from the vertex before to the vertex after. An end has one beyond the other end.
double room(const StrokeVertices& vertices, std::size_t i)
{
    const std::vector<double>& at = vertices.positions;
    const std::size_t last = at.size() - 1;
    if (i == 0 || i == last)
        return (at[1] - at[0] + at[last] - at[last - 1]) / 2;
    return (at[i + 1] - at[i - 1]) / 2;
}

/// A pair at the end of the best sequence of pairs up to there.
struct Link {
    Pair<std::size_t> vertices;
    std::optional<std::size_t> before; ///< an index of links
    double sum;
};

/// The links by vertices of `b`: a binary indexed tree of the best one of each prefix.
class BestLinks {
public:
    explicit BestLinks(std::size_t vertices) : tree_(vertices + 1) {}

    /// The best one that ends before vertex `j`; the first of equals that was added.
    std::optional<std::size_t> before(std::size_t j, const std::vector<Link>& links) const
    {
        std::optional<std::size_t> best;
        for (std::size_t node = j; node > 0; node &= node - 1)
            best = better(best, tree_[node], links);
        return best;
    }

    void add(std::size_t link, const std::vector<Link>& links)
    {
        for (std::size_t node = links[link].vertices.b + 1; node < tree_.size(); node += node & (~node + 1))
            tree_[node] = better(tree_[node], link, links);
    }

private:
    static std::optional<std::size_t> better(std::optional<std::size_t> one, std::optional<std::size_t> other,
                                             const std::vector<Link>& links)
    {
        if (!one || !other)
            return one ? one : other;
        if (links[*one].sum == links[*other].sum)
            return std::min(one, other);
        return links[*one].sum > links[*other].sum ? one : other;
    }

    std::vector<std::optional<std::size_t>> tree_;
};

/// Adds what vertex `i` of `a` may be paired with.
void add_links(const StrokeVertices& a, std::size_t i, const StrokeVertices& b, const BestLinks& best,
               std::vector<Link>& links)
{
    const auto first = b.positions.begin() + 1;
    const auto last = b.positions.end() - 1;
    const auto nearest = std::lower_bound(first, last, a.positions[i]);
    const auto end = nearest + std::min(max_tried, last - nearest);
    for (auto at = nearest - std::min(max_tried, nearest - first); at != end; ++at) {
        const auto j = static_cast<std::size_t>(at - b.positions.begin());
        const double gain = affinity(a, i, b, j, a.positions[i] - b.positions[j]);
        if (gain <= 0)
            continue;
        const std::optional<std::size_t> before = best.before(j, links);
        links.push_back({{i, j}, before, gain + (before ? links[*before].sum : 0)});
    }
}

}

StrokeVertices vertices_of(const MeasuredStroke& stroke)
{
    StrokeVertices vertices{positions_of(stroke), {}};
    const StrokeCorner ends =
        is_closed(stroke) ? corner_between(stroke.back(), stroke.front()) : StrokeCorner{};
    vertices.corners.push_back(ends);
    for (std::size_t i = 1; i < stroke.size(); ++i)
        vertices.corners.push_back(corner_between(stroke[i - 1], stroke[i]));
    vertices.corners.push_back(ends);
    return vertices;
}

double affinity(const StrokeVertices& a, std::size_t i, const StrokeVertices& b, std::size_t j, double way)
{
    const double alike = likeness(a.corners[i], b.corners[j]);
    const double reach = std::max(unseen, alike * alike * alike * std::max(room(a, i), room(b, j)));
    const double tried = std::abs(way) / reach;
    return tried < 1 ? (1 + alike) * (1 - tried * tried) : 0;
}

std::vector<Pair<std::size_t>> vertex_pairs(const StrokeVertices& a, const StrokeVertices& b)
{
    std::vector<Link> links;
    BestLinks best{b.positions.size()};
    for (std::size_t i = 1; i + 1 < a.positions.size(); ++i) {
        const std::size_t old = links.size();
        add_links(a, i, b, best, links);
        for (std::size_t link = old; link < links.size(); ++link)
            best.add(link, links);
    }
    const std::size_t end = b.positions.size() - 1;
    std::vector<Pair<std::size_t>> pairs{{a.positions.size() - 1, end}};
    for (auto link = best.before(end, links); link; link = links[*link].before)
        pairs.push_back(links[*link].vertices);
    pairs.push_back({0, 0});
    std::ranges::reverse(pairs);
    return pairs;
}

namespace {

/// Moves the vertices of `a` to where they are on `b` if the pairs coincide: then more of them may be found
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

/// One stroke's vertices after `at` and before `end`, as fractions of the range from `begin` to `end`.
class SpanVertices {
public:
    SpanVertices(const std::vector<double>& positions, std::size_t begin, std::size_t end)
        : positions_{positions}, begin_{begin}, end_{end}, at_{begin}
    {
    }

    bool is_at_end() const { return at_ + 1 == end_; }

    /// The fraction of the next vertex; 1 at the end.
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
