#include "host/lottie/dashes.hpp"

#include "host/art/dashes.hpp"
#include "host/lottie/measured_outline.hpp"

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

bool has_too_many(const Pattern& pattern, const Drawing& drawing)
{
    double count = 0;
    for (const scene::Outline& outline : drawing.outlines)
        count += (MeasuredOutline{outline}.length() / pattern.sum + 2) *
                 static_cast<double>(pattern.lengths.size()) / 2;
    return count > most_dashes;
}

Drawing dashed_at(const Dashes& dashes, Drawing drawing, double time)
{
    const auto pattern = pattern_at(dashes, time);
    if (!pattern || has_too_many(*pattern, drawing))
        return drawing;
    art::Budget of_one_moment;
    return art::dashed(drawing, pattern->lengths, pattern->offset, of_one_moment);
}

bool has_too_many_at(const Dashes& dashes, const Drawing& drawing, double time)
{
    const auto pattern = pattern_at(dashes, time);
    return pattern && has_too_many(*pattern, drawing);
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
