#include "host/lottie/drawings/dashes.hpp"

#include "host/art/geometry/curves.hpp"
#include "host/art/geometry/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace kfast::lottie {

namespace {

using scene::Curve;
using scene::Outline;
using scene::Vec2;

/// The subsegment between two parameters, with its beginning.
std::pair<Vec2, Curve> part(Vec2 from, const Curve& curve, double first, double last)
{
    if (first <= 0 && last >= 1)
        return {from, curve};
    if (!curve.cubic)
        return {art::spot_on(from, curve, first), scene::line_to(art::spot_on(from, curve, last))};
    const art::CubicPiece piece = art::CubicPiece{{from, curve.c1, curve.c2, curve.to}}.between(first, last);
    return {piece.points[0], scene::cubic_to(piece.points[1], piece.points[2], piece.points[3])};
}

/// Longer pieces keep two distinct ends even when rounded.
constexpr double shortest_piece = 0.1;

}

MeasuredOutline::MeasuredOutline(const Outline& outline) : closed_{outline.closed}
{
    Vec2 from = outline.from;
    double length = 0;
    const auto add = [&](const Curve& curve) {
        segments_.push_back({from, curve});
        length += art::curve_length(from, curve);
        ends_.push_back(length);
        from = curve.to;
    };
    std::ranges::for_each(outline.curves, add);
    if (outline.closed && scene::distance(from, outline.from) > 0)
        add(scene::line_to(outline.from));
}

double MeasuredOutline::parameter(std::size_t index, double length) const
{
    return art::curve_parameter(segments_[index].from, segments_[index].curve, length - begin_of(index));
}

Outline MeasuredOutline::piece(Stretch stretch) const
{
    Outline outline;
    const double min = std::min(shortest_piece, length() / 1000);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const double from = std::max(stretch.from, begin_of(i));
        const double to = std::min(stretch.to, ends_[i]);
        const bool is_whole = from == begin_of(i) && to == ends_[i];
        if (to <= from || (!is_whole && to - from < min))
            continue;
        const auto [begin, curve] =
            part(segments_[i].from, segments_[i].curve, parameter(i, from), parameter(i, to));
        if (outline.curves.empty())
            outline.from = begin;
        outline.curves.push_back(curve);
    }
    return outline;
}

void append(Outline& outline, Outline next)
{
    if (outline.curves.empty())
        outline = std::move(next);
    else
        std::ranges::move(next.curves, std::back_inserter(outline.curves));
}

namespace {

using art::Drawing;

/// The dash pattern at one time.
struct Pattern {
    std::vector<double> lengths;
    double sum = 0;
    double offset = 0;
};

/// Nothing if that is a solid line: without gaps, without length, or too fine for a moment.
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
    const bool is_fine = pattern.sum < Dashes::finest_period && !has_still_lengths(dashes);
    if (!(gaps > 0) || is_fine)
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

/// The maximum at the moments that it comes from; between them there may be a few more.
double max_at_moments(const MovingDrawing& drawing, const Dashes& dashes)
{
    if (drawing.moments.empty())
        return dash_count(dashes, drawing.at(0), 0);
    double max = 0;
    for (const auto& [time, moment] : drawing.moments.list())
        max = std::max(max, dash_count(dashes, drawing.at(time), time));
    return max;
}

MovingDrawing with_moments_of(MovingDrawing drawing, const Dashes& dashes)
{
    for (const art::Channel& length : dashes.lengths)
        drawing.moments.add(length);
    drawing.moments.add(dashes.offset);
    return drawing;
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

bool are_of_scenes(const Dashes& dashes, const MovingDrawing& drawing)
{
    constexpr double most = 800; // of the 1024 of an object, as lengths are rounded
    const std::size_t count = dashes.lengths.size();
    if (count == 0)
        return true;
    return (count % 2 == 0 ? count : 2 * count) <= art::Dashes::max_lengths &&
           max_at_moments(with_moments_of(drawing, dashes), dashes) <= most;
}

DashedDrawing dashed(MovingDrawing drawing, const Dashes& dashes)
{
    const bool line_is_still = drawing.moments.empty();
    drawing = with_moments_of(std::move(drawing), dashes);
    const double max = max_at_moments(drawing, dashes);
    const bool is_still = drawing.moments.empty();
    if (line_is_still && !is_still && max > max_moving_dashes) {
        drawing.moments = {};
        return {dashed(std::move(drawing), at_first(dashes)).drawing, Dashing::stand_still};
    }
    if (max > (is_still ? max_dashes : max_moving_dashes))
        return {std::move(drawing), Dashing::none};
    drawing.changes_form = drawing.changes_form || !is_still;
    drawing.cost += (drawing.points + max) * measuring_cost;
    drawing.points += 4 * max;
    drawing.at = [dashes, at = std::move(drawing.at)](double time) {
        return dashed_at(dashes, at(time), time);
    };
    return {std::move(drawing), Dashing::all};
}

}
