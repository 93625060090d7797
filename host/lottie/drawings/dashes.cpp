#include "host/lottie/drawings/dashes.hpp"

#include "host/art/geometry/dashes.hpp"
#include "host/lottie/drawings/measured_outline.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kfast::lottie {
namespace {

using art::Drawing;

/// At one moment.
struct Pattern {
    std::vector<double> lengths;
    double sum = 0;
    double offset = 0;
};

/// None if that is one line: without gaps, or without length.
std::optional<Pattern> pattern_at(const Dashes& dashes, double time)
{
    Pattern pattern;
    double gaps = 0;
    const std::size_t count = dashes.lengths.size();
    for (std::size_t i = 0; i < (count % 2 == 0 ? count : 2 * count); ++i) {
        pattern.lengths.push_back(std::max(0.0, dashes.lengths[i % count].at(time)));
        pattern.sum += pattern.lengths.back();
        gaps += i % 2 == 0 ? 0 : pattern.lengths.back();
    }
    if (!(gaps > 0))
        return std::nullopt;
    const double offset = dashes.offset.at(time);
    pattern.offset = offset - std::floor(offset / pattern.sum) * pattern.sum;
    return pattern;
}

double dash_count(const Dashes& dashes, const Drawing& drawing, double time)
{
    const auto pattern = pattern_at(dashes, time);
    double count = 0;
    if (pattern)
        for (const scene::Outline& outline : drawing.outlines)
            count += (MeasuredOutline{outline}.length() / pattern->sum + 2) *
                     static_cast<double>(pattern->lengths.size()) / 2;
    return count;
}

/// At the moments that it comes from; between them there may be a few more.
double max_at_moments(const MovingDrawing& drawing, const Dashes& dashes)
{
    if (drawing.moments.empty())
        return dash_count(dashes, drawing.at(0), 0);
    double max = 0;
    for (const auto& [time, moment] : drawing.moments.list())
        max = std::max(max, dash_count(dashes, drawing.at(time), time));
    return max;
}

Drawing dashed_at(const Dashes& dashes, Drawing drawing, double time)
{
    const auto pattern = pattern_at(dashes, time);
    if (!pattern || dash_count(dashes, drawing, time) > max_dashes)
        return drawing;
    art::Budget of_one_moment;
    return art::dashed(drawing, pattern->lengths, pattern->offset, of_one_moment);
}

Dashes at_first(Dashes dashes)
{
    for (art::Channel& length : dashes.lengths)
        length = {length.value()};
    dashes.offset = {dashes.offset.value()};
    return dashes;
}

}

DashedDrawing dashed(MovingDrawing drawing, const Dashes& dashes)
{
    const bool line_is_still = drawing.moments.empty();
    for (const art::Channel& length : dashes.lengths)
        drawing.moments.add(length);
    drawing.moments.add(dashes.offset);
    const double max = max_at_moments(drawing, dashes);
    const bool is_still = drawing.moments.empty();
    if (line_is_still && !is_still && max > max_moving_dashes) {
        drawing.moments = {};
        return {dashed(std::move(drawing), at_first(dashes)).drawing, Dashing::stand_still};
    }
    if (max > (is_still ? max_dashes : max_moving_dashes))
        return {std::move(drawing), Dashing::none};
    drawing.changes_form = drawing.changes_form || !is_still;
    drawing.cost = drawing.cost * measuring_cost + max * measuring_cost;
    drawing.at = [dashes, at = std::move(drawing.at)](double time) {
        return dashed_at(dashes, at(time), time);
    };
    return {std::move(drawing), Dashing::all};
}

}
