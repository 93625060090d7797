#include "host/svg/elements/pen_reader.hpp"

#include "host/art/geometry/curve_length.hpp"
#include "host/art/geometry/dashes.hpp"
#include "host/svg/markup/reported_length.hpp"
#include "host/svg/markup/shortened.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace kfast::svg {
namespace {

/// Dashes and gaps that are shorter together, in pixels of the canvas, look like an even line.
constexpr double finest_dashes = 0.5;

Cap cap_of(std::string_view word)
{
    return word == "round" ? Cap::round : word == "square" ? Cap::square : Cap::butt;
}

Join join_of(std::string_view word, const std::string& layer, art::Losses& losses)
{
    if (word == "miter-clip" || word == "arcs")
        losses.add({"stroke-linejoin " + std::string{word}, layer, {}, "miter"});
    return word == "round" ? Join::round : word == "bevel" ? Join::bevel : Join::miter;
}

double length_of(const art::Drawing& drawing)
{
    double sum = 0;
    for (const scene::Outline& outline : drawing.outlines) {
        const scene::Vec2 end = outline.curves.empty() ? outline.from : outline.curves.back().to;
        sum += art::outline_length(outline) + (outline.closed ? scene::distance(end, outline.from) : 0);
    }
    return sum;
}

/// Empty where they are none, or not as they should be.
std::vector<double> pattern_of(std::string_view text, const Measure& measure)
{
    std::vector<double> pattern;
    for (text = trimmed(text); !text.empty() && text != "none";) {
        const std::size_t end = std::min(text.find_first_of(" ,\t\r\n"), text.size());
        const auto value = length(text.substr(0, end), Axis::diagonal, measure);
        if (!value || *value < 0)
            return {};
        pattern.push_back(*value);
        text = trimmed(text.substr(end));
        if (text.starts_with(','))
            text = trimmed(text.substr(1));
    }
    return pattern;
}

}

std::optional<Pen> pen(const Ink& ink, const Style& style, const Measure& measure, const std::string& layer,
                       art::Losses& losses)
{
    constexpr double widest = 1e6;
    Pen pen{.ink = ink};
    pen.width = std::min(
        widest, reported_length("stroke-width", style["stroke-width"], Axis::diagonal, measure, layer, losses)
                    .value_or(1));
    if (pen.width <= 0)
        return std::nullopt;
    pen.cap = cap_of(style["stroke-linecap"]);
    pen.join = join_of(style["stroke-linejoin"], layer, losses);
    pen.miter_limit = std::max(number(style["stroke-miterlimit"]).value_or(4), 1.0);
    pen.keeps_width = style["vector-effect"].find("non-scaling-stroke") != std::string_view::npos;
    return pen;
}

art::Drawing dashed_line(const art::Drawing& drawing, const Style& style, const Measure& measure,
                         double path_length, double scale, const std::string& layer, art::Budget& budget,
                         art::Losses& losses)
{
    const std::string_view dashes = style["stroke-dasharray"];
    auto pattern = pattern_of(dashes, measure);
    if (pattern.empty() && !dashes.empty() && dashes != "none")
        losses.add({"stroke-dasharray: " + shortened(dashes), layer, {}, "the whole line"});
    double offset = reported_length("stroke-dashoffset", style["stroke-dashoffset"], Axis::diagonal, measure,
                                    layer, losses)
                        .value_or(0);
    if (path_length > 0) {
        const double factor = length_of(drawing) / path_length;
        std::ranges::transform(pattern, pattern.begin(), [&](double each) { return factor * each; });
        offset *= factor;
    }
    const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0);
    if (!(period > 0))
        return drawing;
    if (period * scale < finest_dashes) {
        losses.add({"stroke-dasharray", layer, {}, "an even line: the dashes are too fine to be seen"});
        return drawing;
    }
    return art::dashed(drawing, pattern, offset, budget);
}

}
