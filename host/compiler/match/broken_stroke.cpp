#include "host/compiler/match/broken_stroke.hpp"

#include "host/compiler/match/aligned_strokes.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

constexpr std::size_t sample_count = 256;
constexpr std::size_t max_targets = 64; ///< four samples each, if they are even

Vec2 sum_of(const std::vector<Vec2>& spots)
{
    Vec2 sum;
    for (const Vec2 spot : spots)
        sum = sum + spot;
    return sum;
}

/// Where the parts end, as fractions of the length.
std::vector<double> ends_of_parts(const std::vector<PartTarget>& targets)
{
    double length = 0;
    for (const PartTarget& target : targets)
        length += target.length;
    const double min = length > 0 ? length / 16 / static_cast<double>(targets.size()) : 1;
    std::vector<double> ends;
    ends.reserve(targets.size());
    double passed = 0;
    for (const PartTarget& target : targets)
        ends.push_back(passed += std::max(target.length, min));
    for (double& end : ends)
        end /= passed;
    return ends;
}

/// The place at `position`, or a vertex that is within a fiftieth of 1 / `parts`.
StrokePlace place_near(const std::vector<double>& positions, double position, std::size_t parts)
{
    const double reach = 0.02 / static_cast<double>(parts);
    const StrokePlace place = place_at(positions, position);
    if (position - positions[place.segment] < reach)
        return {place.segment, 0};
    if (positions[place.segment + 1] - position < reach)
        return {place.segment + 1, 0};
    return place;
}

/// For all shifts of a closed stroke's start: how near the parts are to their targets. The sum of squared
/// distances between their centres, relative to those of the whole drawings, is less the larger this is, but
/// for what the shift hardly changes.
class PartAgreement {
public:
    PartAgreement(const MeasuredStroke& whole, const std::vector<PartTarget>& targets,
                  const std::vector<double>& ends)
        : samples_{samples_of(whole, sample_count)}
    {
        std::size_t begin = 0;
        const Vec2 middle = middle_of(targets);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const auto end = static_cast<std::size_t>(std::lround(ends[i] * sample_count));
            pulls_.insert(pulls_.end(), end - begin, targets[i].centre - middle);
            begin = end;
        }
        const Vec2 centre = (1.0 / sample_count) * sum_of(samples_);
        for (Vec2& sample : samples_)
            sample = sample - centre;
    }

    double at(std::size_t shift) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < sample_count; ++i)
            sum += dot(samples_[(i + shift) % sample_count], pulls_[i]);
        return sum;
    }

    /// More than rounding adds to an agreement.
    double noise() const
    {
        double squares = 0;
        for (std::size_t i = 0; i < sample_count; ++i)
            squares += dot(samples_[i], samples_[i]) + dot(pulls_[i], pulls_[i]);
        return 1e-9 * squares;
    }

private:
    static Vec2 middle_of(const std::vector<PartTarget>& targets)
    {
        Vec2 sum;
        for (const PartTarget& target : targets)
            sum = sum + target.centre;
        return (1.0 / static_cast<double>(targets.size())) * sum;
    }

    std::vector<Vec2> samples_; ///< relative to their centre
    std::vector<Vec2> pulls_;   ///< for each sample the position of its target
};

MeasuredStroke begun_for(const MeasuredStroke& whole, const std::vector<PartTarget>& targets,
                         const std::vector<double>& ends)
{
    if (!is_closed(whole) || targets.size() == 1 || targets.size() > max_targets)
        return whole;
    const PartAgreement agreement{whole, targets, ends};
    const Shift best = best_shift(sample_count, agreement.noise(),
                                  [&agreement](std::size_t shift) { return agreement.at(shift); });
    const double start = static_cast<double>(best.steps) / sample_count;
    return begun_at(whole, place_near(positions_of(whole), start, targets.size()));
}

}

PartTarget target_of(const scene::Stroke& stroke)
{
    if (stroke.segments.empty())
        return {0, in_pixels(stroke.from)};
    const MeasuredStroke target = measured(stroke);
    constexpr std::size_t samples = 32;
    return {length_of(target), (1.0 / samples) * sum_of(samples_of(target, samples))};
}

std::vector<MeasuredStroke> broken(const MeasuredStroke& whole, const std::vector<PartTarget>& targets)
{
    const std::vector<double> ends = ends_of_parts(targets);
    const MeasuredStroke begun = begun_for(whole, targets, ends);
    const std::vector<double> positions = positions_of(begun);
    std::vector<MeasuredStroke> parts;
    StrokePlace begin;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const StrokePlace end = place_near(positions, ends[i], ends.size());
        parts.push_back(part_of(begun, begin, end));
        begin = end;
    }
    parts.push_back(part_of(begun, begin, {begun.size(), 0}));
    return parts;
}

}
