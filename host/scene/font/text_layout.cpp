#include "host/scene/font/text_layout.hpp"

#include "host/text/characters.hpp"

#include <string>
#include <utility>

namespace kfast::scene {
namespace {

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

class TextSetter {
public:
    TextSetter(const TextStyle& style, std::size_t points_left)
        : style_{style}, scale_{style.size / style.font->units_per_em()}, points_left_{points_left}
    {
    }

    /// Returns whether there were enough points.
    bool set(std::u32string_view line, double baseline)
    {
        const std::vector<double> stops = stops_of(line);
        const double begin = style_.at.x - share_left_of_anchor(style_.align) * stops.back();
        for (std::size_t i = 0; i < line.size(); ++i)
            if (!set(*style_.font->letter(line[i]), {begin + stops[i], baseline}))
                return false;
        return true;
    }

    std::vector<Outline> take() { return std::move(outlines_); }

private:
    /// Where each letter begins, from the beginning of the line; the last one is where the line ends.
    std::vector<double> stops_of(std::u32string_view line) const
    {
        std::vector<double> stops;
        double x = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (i > 0)
                x += style_.spacing + scale_ * style_.font->kerning(line[i - 1], line[i]);
            stops.push_back(x);
            x += scale_ * style_.font->letter(line[i])->advance;
        }
        stops.push_back(x);
        return stops;
    }

    bool set(const Letter& letter, Vec2 origin)
    {
        for (const Outline& outline : letter.outlines) {
            const std::size_t points = outline.curves.size() + 1;
            if (points > points_left_)
                return false;
            points_left_ -= points;
            outlines_.push_back(placed(outline, origin));
        }
        return true;
    }

    Outline placed(const Outline& outline, Vec2 origin) const
    {
        const auto moved = [&](Vec2 spot) { return origin + scale_ * spot; };
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

std::optional<std::vector<Outline>> set_text(std::string_view text, const TextStyle& style,
                                             std::size_t points_left)
{
    TextSetter setter{style, points_left};
    double baseline = style.at.y;
    for (const std::u32string& line : lines_of(text)) {
        if (!setter.set(line, baseline))
            return std::nullopt;
        baseline += style.leading;
    }
    return setter.take();
}

}
