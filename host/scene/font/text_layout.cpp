#include "host/scene/font/text_layout.hpp"

#include "host/text/characters.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast::scene {

std::vector<std::u32string> lines_of(std::string_view text)
{
    std::vector<std::u32string> lines(1);
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = code_point_at(text, at);
        at += point.length;
        if (point.value == U'\n')
            lines.emplace_back();
        else
            lines.back() += point.value;
    }
    return lines;
}

double share_left_of_anchor(Align align)
{
    switch (align) {
    case Align::left:
        return 0;
    case Align::center:
        return 0.5;
    case Align::right:
        return 1;
    }
    return 0;
}

namespace {

double scale_of(const TextStyle& style) { return style.size / style.font->units_per_em(); }

/// Where each letter begins, from the beginning of the line; the last one is where the line ends.
std::vector<double> stops_of(std::u32string_view line, const TextStyle& style)
{
    const double scale = scale_of(style);
    std::vector<double> stops;
    double x = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0)
            x += style.spacing + scale * style.font->kerning(line[i - 1], line[i]);
        stops.push_back(x);
        x += scale * style.font->letter(line[i])->advance;
    }
    stops.push_back(x);
    return stops;
}

/// How high the capitals are, in pixels; without an H, as high as the em.
double height_of_capitals(const TextStyle& style)
{
    const Letter* const letter = style.font->letter(U'H');
    if (letter == nullptr || letter->outlines.empty())
        return style.size;
    double top = 0;
    for (const Outline& outline : letter->outlines) {
        top = std::min(top, outline.from.y);
        for (const Curve& curve : outline.curves)
            top = std::min(top, curve.to.y);
    }
    return -top * scale_of(style);
}

class TextSetter {
public:
    TextSetter(const TextStyle& style, std::size_t points_left)
        : style_{style}, scale_{scale_of(style)}, points_left_{points_left}
    {
    }

    /// Returns whether there were enough points.
    bool set(std::u32string_view line, double baseline)
    {
        const std::vector<double> stops = stops_of(line, style_);
        const double before = share_left_of_anchor(style_.align) * stops.back();
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Letter& letter = *style_.font->letter(line[i]);
            const double x = stops[i] - before;
            if (!set(letter, style_.along ? on_path(letter, style_.start + x)
                                          : PathPlace{{style_.at.x + x, baseline}, {1, 0}}))
                return false;
        }
        return true;
    }

    std::vector<Outline> take() { return std::move(outlines_); }

private:
    /// The middle of the letter is on the path, and its baseline along it.
    PathPlace on_path(const Letter& letter, double begin) const
    {
        const double half = scale_ * letter.advance / 2;
        const PathPlace middle = style_.along->at(begin + half);
        return {middle.spot - half * middle.direction, middle.direction};
    }

    bool set(const Letter& letter, const PathPlace& origin)
    {
        for (const Outline& outline : letter.outlines) {
            const std::size_t points = outline.curves.size() + 1;
            if (points > points_left_)
                return false;
            points_left_ -= points;
            outlines_.push_back(placed(outline, origin));
            outlines_.back().begins_letter = &outline == letter.outlines.data();
        }
        return true;
    }

    Outline placed(const Outline& outline, const PathPlace& origin) const
    {
        const Vec2 x = scale_ * origin.direction;
        const Vec2 y{-x.y, x.x};
        const auto moved = [&](Vec2 spot) { return origin.spot + (spot.x * x + spot.y * y); };
        Outline result{.from = moved(outline.from), .curves = {}, .closed = outline.closed};
        result.curves.reserve(outline.curves.size());
        for (const Curve& curve : outline.curves)
            result.curves.push_back({curve.cubic, moved(curve.c1), moved(curve.c2), moved(curve.to)});
        return result;
    }

    const TextStyle& style_;
    double scale_;
    std::size_t points_left_;
    std::vector<Outline> outlines_;
};

}

double TextStyle::first_baseline(std::size_t lines) const
{
    const double below = leading * static_cast<double>(lines - 1);
    switch (vertical) {
    case VerticalAlign::baseline:
        break;
    case VerticalAlign::top:
        return at.y + height_of_capitals(*this);
    case VerticalAlign::middle:
        return at.y + (height_of_capitals(*this) - below) / 2;
    case VerticalAlign::bottom:
        return at.y - below;
    }
    return at.y;
}

double width_of(std::u32string_view line, const TextStyle& style) { return stops_of(line, style).back(); }

std::optional<std::vector<Outline>> set_text(std::string_view text, const TextStyle& style,
                                             std::size_t points_left)
{
    TextSetter setter{style, points_left};
    const std::vector<std::u32string> lines = lines_of(text);
    double baseline = style.first_baseline(lines.size());
    for (const std::u32string& line : lines) {
        if (!setter.set(line, baseline))
            return std::nullopt;
        baseline += style.leading;
    }
    return setter.take();
}

}
