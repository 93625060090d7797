#include "host/art/prepare/merged_outline.hpp"

#include "host/art/geometry/curves.hpp"
#include "host/art/geometry/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::art {
namespace {

using scene::Outline;
using scene::Vec2;

/// The fraction of the tolerance for straight lines instead of curves; the rest is for merging.
constexpr double straight_share = 0.25;

/// Bytes of a curve compared with those of a line as short as its parts would be, about.
constexpr int curve_cost = 5;

/// Beyond that a join is a corner, and stays one.
constexpr double sharpest_join = 0.5;

double length(Vec2 way) { return std::sqrt(dot(way, way)); }

CubicPiece straight_piece(Vec2 from, Vec2 to)
{
    const scene::Curve curve = as_cubic(from, scene::line_to(to));
    return {{from, curve.c1, curve.c2, to}};
}

bool is_point(const CubicPiece& piece)
{
    constexpr double no_length = 1e-9;
    return std::ranges::all_of(piece.points, [&](Vec2 point) {
        return std::abs(point.x - piece.points[0].x) <= no_length &&
               std::abs(point.y - piece.points[0].y) <= no_length;
    });
}

}

MergedOutline::MergedOutline(std::vector<Outline*> outlines, std::span<const TweenRange> tweens,
                             double tolerance, const OutlineEdge& edge)
    : outlines_{std::move(outlines)},
      tweens_{tweens},
      tolerance_{tolerance / tween_growth(tweens)},
      edge_{edge}
{
    read();
}

void MergedOutline::read()
{
    straight_.assign(outlines_.front()->curves.size(), true);
    for (const Outline* outline : outlines_) {
        auto& pieces = pieces_.emplace_back();
        pieces.reserve(count());
        Vec2 from = outline->from;
        for (std::size_t i = 0; i < count(); ++i) {
            const scene::Curve curve = as_cubic(from, outline->curves[i]);
            pieces.push_back({{from, curve.c1, curve.c2, curve.to}});
            straight_[i] = straight_[i] && !outline->curves[i].cubic;
            from = curve.to;
        }
    }
}

void MergedOutline::write()
{
    drop_points();
    straighten();
    find_joins();
    for (std::size_t key = 0; key < outlines_.size(); ++key)
        outlines_[key]->curves.clear();
    for (std::size_t begin = 0; begin < count();) {
        const Run run = best_run(begin);
        for (std::size_t key = 0; key < outlines_.size(); ++key) {
            const auto& points = run.pieces[key].points;
            outlines_[key]->curves.push_back(run.straight ? scene::line_to(points[3])
                                                          : scene::cubic_to(points[1], points[2], points[3]));
        }
        begin = run.end;
    }
}

/// Drops the segments that are points in all keys.
void MergedOutline::drop_points()
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count(); ++i) {
        if (std::ranges::all_of(pieces_, [&](const auto& pieces) { return is_point(pieces[i]); }))
            continue;
        for (auto& pieces : pieces_)
            pieces[kept] = pieces[i];
        straight_[kept++] = straight_[i];
    }
    straight_.resize(kept);
    for (auto& pieces : pieces_)
        pieces.resize(kept, CubicPiece{});
}

void MergedOutline::straighten()
{
    for (std::size_t i = 0; i < count(); ++i) {
        if (straight_[i] || !is_straight(i))
            continue;
        straight_[i] = true;
        for (auto& pieces : pieces_)
            pieces[i] = straight_piece(pieces[i].points[0], pieces[i].points[3]);
    }
}

/// Whether its control points are, in all keys, at the same fractions of the chord, so that it is straight in
/// tweens, too; and between its ends, so that it goes no further. They weigh at most 3/4 together.
bool MergedOutline::is_straight(std::size_t segment) const
{
    const auto longest = std::ranges::max_element(pieces_, {}, [&](const auto& pieces) {
        return dot(pieces[segment].chord(), pieces[segment].chord());
    });
    const CubicPiece& guide = (*longest)[segment];
    const double square = dot(guide.chord(), guide.chord());
    if (!(square > 0))
        return false;
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
        const double share = dot(guide.points[i] - guide.points[0], guide.chord()) / square;
        if (!(share >= 0 && share <= 1))
            return false;
        for (const auto& pieces : pieces_) {
            const auto& points = pieces[segment].points;
            if (!(0.75 * distance(points[i], points[0] + share * pieces[segment].chord()) <=
                  straight_share * tolerance_))
                return false;
        }
    }
    const auto chords = directions(segment, &CubicPiece::chord);
    return turns_little(directions(segment, &CubicPiece::first_direction), chords, edge_.corner_factor) &&
           turns_little(directions(segment, &CubicPiece::last_direction), chords, edge_.corner_factor);
}

template <typename Direction>
std::vector<Vec2> MergedOutline::directions(std::size_t segment, const Direction& direction) const
{
    std::vector<Vec2> result;
    result.reserve(pieces_.size());
    for (const auto& pieces : pieces_)
        result.push_back((pieces[segment].*direction)());
    return result;
}

/// Two arms of a corner may rotate by that, and each of them once when it is straightened and once when it is
/// merged: a quarter of the tolerance each.
bool MergedOutline::turns_little(std::span<const Vec2> before, std::span<const Vec2> now, double factor) const
{
    if (!has_edge())
        return true;
    return edge_.half_width * factor * greatest_turn(before, now, tweens_) <= edge_.tolerance / 4;
}

void MergedOutline::find_joins()
{
    widths_.assign(count(), 0);
    for (std::size_t i = 1; i < count(); ++i) {
        if (!can_merge_at(i))
            continue;
        double before = 0;
        double behind = 0;
        for (const auto& pieces : pieces_) {
            before += length(pieces[i - 1].last_slope());
            behind += length(pieces[i].first_slope());
        }
        widths_[i] = behind / before;
    }
    smooth_until_.assign(count(), count());
    for (std::size_t i = count(); i-- > 1;)
        smooth_until_[i - 1] = widths_[i] > 0 ? smooth_until_[i] : i;
}

/// Whether the outline goes on smoothly there, and no tip of a line is lost: at an angle it protrudes by half
/// the width divided by the cosine of half the angle.
bool MergedOutline::can_merge_at(std::size_t segment)
{
    constexpr double min_slope = 1e-6;
    const auto before = directions(segment - 1, &CubicPiece::last_slope);
    const auto behind = directions(segment, &CubicPiece::first_slope);
    for (std::size_t key = 0; key < before.size(); ++key) {
        const double lengths = length(before[key]) * length(behind[key]);
        if (!(lengths > min_slope) || dot(before[key], behind[key]) < std::cos(sharpest_join) * lengths)
            return false;
    }
    if (!has_edge())
        return true;
    const double turn = greatest_turn(before, behind, tweens_);
    return turn <= sharpest_join && edge_.half_width * (1 / std::cos(turn / 2) - 1) <= edge_.tolerance / 4;
}

MergedOutline::Run MergedOutline::best_run(std::size_t begin) const
{
    Run best{begin, begin + 1, straight_[begin], {}};
    for (const auto& pieces : pieces_)
        best.pieces.push_back(pieces[begin]);
    const auto take_better = [&](std::optional<Run> run) {
        if (run && saved(*run) > saved(best))
            best = *std::move(run);
    };
    if (straight_[begin])
        take_better(longest(begin, [&](std::size_t end) { return line(begin, end); }));
    take_better(longest(begin, [&](std::size_t end) { return curve(begin, end); }));
    return best;
}

int MergedOutline::saved(const Run& run) const
{
    int cost = run.straight ? -1 : -curve_cost;
    for (std::size_t i = run.begin; i < run.end; ++i)
        cost += straight_[i] ? 1 : curve_cost;
    return cost;
}

/// First in steps that double, then by halving what is left between.
template <typename Attempt>
std::optional<MergedOutline::Run> MergedOutline::longest(std::size_t begin, const Attempt& attempt) const
{
    std::optional<Run> best;
    std::size_t good = begin + 1;
    std::size_t bad = smooth_until_[begin] + 1;
    const auto reaches = [&](std::size_t end) {
        auto run = attempt(end);
        if (!run)
            return false;
        best = std::move(run);
        return true;
    };
    for (std::size_t step = 2; begin + step < bad; step *= 2)
        (reaches(begin + step) ? good : bad) = begin + step;
    while (bad - good > 1) {
        const std::size_t middle = good + (bad - good) / 2;
        (reaches(middle) ? good : bad) = middle;
    }
    return best;
}

std::vector<double> MergedOutline::shares(std::size_t begin, std::size_t end) const
{
    std::vector<double> ends{0};
    double width = 1;
    for (std::size_t i = begin; i < end; ++i) {
        if (i > begin)
            width *= widths_[i];
        ends.push_back(ends.back() + width);
    }
    const double whole = ends.back();
    for (double& at : ends)
        at /= whole;
    ends.back() = 1;
    return ends;
}

/// Both are straight between corners, and so farthest apart at one.
std::optional<MergedOutline::Run> MergedOutline::line(std::size_t begin, std::size_t end) const
{
    Run run{begin, end, true, {}};
    const auto ends = shares(begin, end);
    for (const auto& pieces : pieces_) {
        const Vec2 from = pieces[begin].points[0];
        const Vec2 to = pieces[end - 1].points[3];
        for (std::size_t i = begin; i < end; ++i)
            if (!straight_[i] || !(distance(pieces[i].points[3], from + ends[i - begin + 1] * (to - from)) <=
                                   (1 - straight_share) * tolerance_))
                return std::nullopt;
        run.pieces.push_back(straight_piece(from, to));
    }
    return keeps_ends(run) ? std::optional{std::move(run)} : std::nullopt;
}

std::optional<MergedOutline::Run> MergedOutline::curve(std::size_t begin, std::size_t end) const
{
    for (const Handles handles : {Handles::free, Handles::kept})
        if (auto run = curve(begin, end, handles))
            return run;
    return std::nullopt;
}

std::optional<MergedOutline::Run> MergedOutline::curve(std::size_t begin, std::size_t end,
                                                       Handles handles) const
{
    Run run{begin, end, false, {}};
    const auto ends = shares(begin, end);
    for (std::size_t key = 0; key < pieces_.size(); ++key) {
        const CubicPiece piece = fitted(key, begin, ends, handles);
        if (!(dot(piece.first_slope(), pieces_[key][begin].first_slope()) > 0) ||
            !(dot(piece.last_slope(), pieces_[key][end - 1].last_slope()) > 0))
            return std::nullopt;
        for (std::size_t i = begin; i < end; ++i)
            if (!(distance(pieces_[key][i], piece.between(ends[i - begin], ends[i - begin + 1])) <=
                  (1 - straight_share) * tolerance_))
                return std::nullopt;
        run.pieces.push_back(piece);
    }
    return keeps_ends(run) ? std::optional{std::move(run)} : std::nullopt;
}

/// Fits with samples inside of each segment, in proportion to its part of the parameter.
CubicPiece MergedOutline::fitted(std::size_t key, std::size_t begin, const std::vector<double>& shares,
                                 Handles handles) const
{
    const auto& pieces = pieces_[key];
    const std::size_t last = begin + shares.size() - 2;
    CubicFit fit{pieces[begin].points[0], pieces[last].points[3]};
    for (std::size_t i = begin; i <= last; ++i) {
        const double from = shares[i - begin];
        const double width = shares[i - begin + 1] - from;
        for (const double at : {0.25, 0.5, 0.75, 1.0})
            fit.take(from + at * width, pieces[i].at(at), width);
    }
    return handles == Handles::free ? fit.free()
                                    : fit.along(pieces[begin].first_slope(), pieces[last].last_slope());
}

bool MergedOutline::keeps_ends(const Run& run) const
{
    if (!has_edge())
        return true;
    std::vector<Vec2> first;
    std::vector<Vec2> last;
    for (const CubicPiece& piece : run.pieces) {
        first.push_back(piece.first_slope());
        last.push_back(piece.last_slope());
    }
    return turns_little(directions(run.begin, &CubicPiece::first_slope), first, end_growth(run.begin)) &&
           turns_little(directions(run.end - 1, &CubicPiece::last_slope), last, end_growth(run.end));
}

/// Where the outline goes on smoothly there is no tip: with less than 1/2 between them, two arms meet at most
/// 1.04 half widths away, and a rotation moves that by less than 1.25 of them.
double MergedOutline::end_growth(std::size_t segment) const
{
    constexpr double smooth_growth = 1.25;
    return segment < count() && widths_[segment] > 0 ? smooth_growth : edge_.corner_factor;
}

}
