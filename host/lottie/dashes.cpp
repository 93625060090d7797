#include "host/lottie/dashes.hpp"

#include "host/lottie/measured_outline.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kfast::lottie {
namespace {

using art::Drawing;

/// At one moment. The number of lengths is even.
struct Pattern {
    std::vector<double> lengths;
    double sum = 0;
    double offset = 0; ///< 0 to sum
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

double dash_count(const Pattern& pattern, const std::vector<MeasuredOutline>& outlines)
{
    double count = 0;
    for (const MeasuredOutline& outline : outlines)
        count += (outline.length() / pattern.sum + 2) * static_cast<double>(pattern.lengths.size()) / 2;
    return count;
}

/// Without length, it is seen with round and square caps.
scene::Outline dot(scene::Spot spot) { return {spot, {scene::line_to(spot)}, false}; }

void add_dash(const MeasuredOutline& outline, Stretch stretch, Drawing& drawing)
{
    constexpr double longest_dot = 0.1;
    if (stretch.to < 0)
        return;
    if (stretch.to - stretch.from < longest_dot) {
        drawing.outlines.push_back(dot(outline.at(stretch.to)));
        return;
    }
    scene::Outline piece = outline.piece(stretch);
    if (!piece.curves.empty())
        drawing.outlines.push_back(std::move(piece));
}

void add_dashes(const MeasuredOutline& outline, const Pattern& pattern, Drawing& drawing)
{
    double from = -pattern.offset;
    for (std::size_t i = 0; from < outline.length(); i = (i + 1) % pattern.lengths.size()) {
        const double to = from + pattern.lengths[i];
        if (i % 2 == 0)
            add_dash(outline, {from, to}, drawing);
        from = to;
    }
}

std::vector<MeasuredOutline> measured(const Drawing& drawing)
{
    return {drawing.outlines.begin(), drawing.outlines.end()};
}

Drawing dashed_at(const Dashes& dashes, Drawing drawing, double time)
{
    const auto pattern = pattern_at(dashes, time);
    if (!pattern)
        return drawing;
    const auto outlines = measured(drawing);
    if (dash_count(*pattern, outlines) > most_dashes)
        return drawing;
    Drawing result;
    for (const MeasuredOutline& outline : outlines)
        add_dashes(outline, *pattern, result);
    return result;
}

bool has_too_many_at(const Dashes& dashes, const Drawing& drawing, double time)
{
    const auto pattern = pattern_at(dashes, time);
    return pattern && dash_count(*pattern, measured(drawing)) > most_dashes;
}

}

MovingDrawing dashed(MovingDrawing drawing, const Dashes& dashes)
{
    for (const art::Channel& length : dashes.lengths)
        drawing.moments.add(length);
    drawing.moments.add(dashes.offset);
    drawing.changes_form = drawing.changes_form || !drawing.moments.empty();
    drawing.cost = drawing.cost * measuring_cost + most_dashes / 4;
    drawing.at = [dashes, at = std::move(drawing.at)](double time) {
        return dashed_at(dashes, at(time), time);
    };
    return drawing;
}

bool has_too_many(const MovingDrawing& drawing, const Dashes& dashes)
{
    if (drawing.moments.empty())
        return has_too_many_at(dashes, drawing.at(0), 0);
    return std::ranges::any_of(drawing.moments.list(), [&](const auto& moment) {
        return has_too_many_at(dashes, drawing.at(moment.first), moment.first);
    });
}

}
