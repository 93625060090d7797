#include "host/compiler/match/aligned_strokes.hpp"

#include "host/compiler/match/corresponding_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kfast {

namespace {

/// Less than one and a half degrees of a circle apart.
constexpr std::size_t sample_count = 256;

std::vector<Vec2> centred_samples_of(const MeasuredStroke& stroke)
{
    std::vector<Vec2> samples = samples_of(stroke, sample_count);
    Vec2 sum;
    for (const Vec2 sample : samples)
        sum = sum + sample;
    for (Vec2& sample : samples)
        sample = sample - (1.0 / sample_count) * sum;
    return samples;
}

/// For each shift the sum of the dot products of samples that meet: the greater it is, the nearer the strokes
/// are to each other.
std::array<double, sample_count> agreements(const std::vector<Vec2>& fixed, const std::vector<Vec2>& moved)
{
    constexpr std::size_t at_once = 8; // sums that do not wait for each other
    static_assert(sample_count % at_once == 0);
    std::vector<Vec2> twice = moved;
    twice.insert(twice.end(), moved.begin(), moved.end());
    std::array<double, sample_count> sums{};
    for (std::size_t shift = 0; shift < sample_count; shift += at_once)
        for (std::size_t i = 0; i < sample_count; ++i)
            for (std::size_t k = shift; k < shift + at_once; ++k)
                sums[k] += dot(fixed[i], twice[i + k]);
    return sums;
}

double square_sum(const std::vector<Vec2>& samples)
{
    double sum = 0;
    for (const Vec2 sample : samples)
        sum += dot(sample, sample);
    return sum;
}

/// A distance along a closed stroke, in the shorter direction.
double around(double way) { return way - std::floor(way + 0.5); }

/// A vertex of each stroke to begin at.
struct Start {
    std::size_t fixed = 0;
    std::size_t moved = 0;
    double way = 0; ///< from the latter to where the former fits best
    double affinity = 0;
};

/// The best of the vertices of the moved stroke around the position where vertex `i` fits best.
Start best_start(const StrokeVertices& fixed, std::size_t i, const StrokeVertices& moved, double shift)
{
    const double place = fixed.positions[i] + shift;
    const std::size_t segments = moved.positions.size() - 1;
    const std::size_t tried = std::min<std::size_t>(segments, 16);
    const std::size_t before = place_at(moved.positions, place - std::floor(place)).segment;
    Start best;
    for (std::size_t k = 0; k < tried; ++k) {
        const std::size_t j = (before + 1 + segments - tried / 2 + k) % segments;
        const double way = around(place - moved.positions[j]);
        if (const double found = affinity(fixed, i, moved, j, way); found > best.affinity)
            best = {i, j, way, found};
    }
    return best;
}

/// `starts` vertices of the fixed stroke may become its start.
AlignedStrokes begun_at_best(const MeasuredStroke& fixed, const MeasuredStroke& moved, double shift,
                             std::size_t starts)
{
    const StrokeVertices fixed_vertices = vertices_of(fixed);
    const StrokeVertices moved_vertices = vertices_of(moved);
    constexpr double noise = 1e-9; // the first of equally good starts
    Start best;
    for (std::size_t i = 0; i < starts; ++i)
        if (const Start found = best_start(fixed_vertices, i, moved_vertices, shift);
            found.affinity > best.affinity + noise)
            best = found;
    if (best.affinity == 0)
        return {fixed, begun_at(moved, place_at(moved_vertices.positions, shift))};
    return {best.fixed == 0 ? fixed : begun_at(fixed, {best.fixed, 0}), begun_at(moved, {best.moved, 0}),
            -best.way};
}

AlignedStrokes aligned_to(const MeasuredStroke& fixed, std::size_t starts, const MeasuredStroke& closed,
                          Reversal reversal)
{
    const std::vector<Vec2> target = centred_samples_of(fixed);
    const std::vector<Vec2> forwards = centred_samples_of(closed);
    const std::vector<Vec2> backwards{forwards.rbegin(), forwards.rend()};
    const double noise = 1e-9 * std::sqrt(square_sum(target) * square_sum(forwards));
    const auto best = [&](const std::vector<Vec2>& samples) {
        const auto all = agreements(target, samples);
        return best_shift(sample_count, noise, [&all](std::size_t steps) { return all[steps]; });
    };
    const auto share = [](Shift shift) { return static_cast<double>(shift.steps) / sample_count; };
    const Shift forward = best(forwards);
    if (reversal == Reversal::allowed)
        if (const Shift backward = best(backwards); backward.agreement > forward.agreement + noise)
            return begun_at_best(fixed, reversed(closed), share(backward), starts);
    return begun_at_best(fixed, closed, share(forward), starts);
}

}

AlignedStrokes aligned(const MeasuredStroke& a, const MeasuredStroke& b, Reversal reversal)
{
    if (is_closed(b))
        return aligned_to(a, is_closed(a) ? a.size() : 1, b, reversal);
    if (!is_closed(a))
        return {a, b};
    AlignedStrokes turned = aligned_to(b, 1, a, reversal);
    return {std::move(turned.b), std::move(turned.a), -turned.offset};
}

AlignedStrokes aligned_to_part(const MeasuredStroke& part, const MeasuredStroke& partner)
{
    if (is_closed(partner))
        return aligned_to(part, 1, partner, Reversal::forbidden);
    return {part, partner};
}

}
