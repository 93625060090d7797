#include "host/svg/elements/style_reader.hpp"

#include "host/art/geometry/curves.hpp"
#include "host/art/geometry/drawing.hpp"
#include "host/svg/markup/length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

namespace kfast::svg {

namespace {

using scene::Vec2;

std::vector<std::string_view> words(std::string_view text)
{
    std::vector<std::string_view> result;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t end = std::min(text.find_first_of(" \t\r\n,"), text.size());
        if (end > 0)
            result.push_back(text.substr(0, end));
        text = text.substr(std::min(std::max<std::size_t>(end, 1), text.size()));
    }
    return result;
}

struct Keyword {
    std::string_view name;
    double share;
};
constexpr std::array<Keyword, 5> keywords{
    {{"left", 0}, {"top", 0}, {"center", 0.5}, {"right", 1}, {"bottom", 1}}};

double along(std::string_view word, Axis axis, const Measure& measure)
{
    const auto keyword = std::ranges::find(keywords, word, &Keyword::name);
    if (keyword != keywords.end())
        return keyword->share * (axis == Axis::x ? measure.width : measure.height);
    return length(word, axis, measure).value_or(0);
}

std::optional<Vec2> origin(std::string_view text, const Measure& measure)
{
    auto parts = words(text);
    if (parts.empty())
        return std::nullopt;
    if (parts.size() == 1)
        parts.push_back("center");
    if (parts[0] == "top" || parts[0] == "bottom" || parts[1] == "left" || parts[1] == "right")
        std::swap(parts[0], parts[1]);
    return Vec2{along(parts[0], Axis::x, measure), along(parts[1], Axis::y, measure)};
}

art::Affine about(const art::Affine& affine, Vec2 origin)
{
    return art::moved(origin.x, origin.y) * affine * art::moved(-origin.x, -origin.y);
}

}

art::Affine about_origin(const art::Affine& affine, const Style& style, const Measure& measure)
{
    const auto found = origin(style["transform-origin"], measure);
    return found ? about(affine, *found) : affine;
}

bool turns_about_own_box(const Style& style)
{
    return style["transform-box"] == "fill-box" && !style["transform-origin"].empty();
}

art::Affine about_own_box(const Part& part, const Style& style)
{
    const auto box = box_of(part, {});
    if (!box)
        return part.own;
    const Vec2 size = box->max - box->min;
    const Vec2 inside = origin(style["transform-origin"], {size.x, size.y}).value_or(Vec2{});
    return about(part.own, box->min + inside);
}

double font_size(const Style& style, const Measure& outside)
{
    const auto size = length(style["font-size"], Axis::y, outside);
    return size && *size > 0 ? *size : outside.font_size;
}

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

Dashes dashes_of(const art::Drawing& drawing, const Style& style, const Measure& measure, double path_length,
                 double scale, const std::string& layer, art::Losses& losses)
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
        return {};
    if (period * scale < finest_dashes) {
        losses.add({"stroke-dasharray", layer, {}, "an even line: the dashes are too fine to be seen"});
        return {};
    }
    if (pattern.size() % 2 != 0)
        pattern.insert(pattern.end(), pattern.begin(), pattern.end());
    return {std::move(pattern), offset};
}

bool are_of_scenes(const Dashes& dashes, const art::Drawing& drawing)
{
    constexpr double most = 800; // of the 1024 of an object, as lengths are rounded
    const double period = std::accumulate(dashes.lengths.begin(), dashes.lengths.end(), 0.0);
    const double strokes = static_cast<double>(drawing.outlines.size());
    const double count = static_cast<double>(dashes.lengths.size()) / 2;
    return dashes.lengths.size() <= art::Dashes::max_lengths &&
           (length_of(drawing) / period + 2 * strokes) * count < most;
}

void draw_whole_line(Dashes& dashes, const art::Drawing& drawing, double scale)
{
    constexpr double near = 0.02;
    constexpr double spare = 0.5; // px
    if (drawing.outlines.size() != 1 || dashes.lengths.size() != 2)
        return;
    const double length = length_of(drawing);
    if (std::abs(dashes.lengths[0] - length) > near * length || dashes.lengths[1] < (1 - near) * length)
        return;
    const double factor = (length + spare / scale) / std::min(dashes.lengths[0], dashes.lengths[1]);
    for (double& each : dashes.lengths)
        each *= std::max(factor, 1.0);
    dashes.offset *= std::max(factor, 1.0);
}

}
