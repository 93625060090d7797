#include "host/compiler/match/match_by_letters.hpp"

#include "core/scene/kfb_limits.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace kfast {
namespace {

using Letter = std::span<const scene::Stroke>;

std::vector<Letter> letters_of(const scene::Key& key)
{
    const Letter strokes{key.drawing.strokes};
    std::vector<std::size_t> begins = key.letters;
    if (begins.empty() && !strokes.empty())
        begins.push_back(0);
    begins.push_back(strokes.size());
    std::vector<Letter> letters;
    for (std::size_t i = 0; i + 1 < begins.size(); ++i)
        letters.push_back(strokes.subspan(begins[i], begins[i + 1] - begins[i]));
    return letters;
}

/// Of the box around the points where segments begin and end.
scene::Point centre_of(Letter letter)
{
    scene::Point low = letter.front().from;
    scene::Point high = low;
    const auto include = [&](scene::Point point) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    };
    for (const scene::Stroke& stroke : letter) {
        include(stroke.from);
        for (const scene::Segment& segment : stroke.segments)
            include(segment.to);
    }
    return {static_cast<std::int16_t>((low.x + high.x) / 2), static_cast<std::int16_t>((low.y + high.y) / 2)};
}

scene::Stroke drawn_together(const scene::Stroke& stroke, scene::Point point)
{
    scene::Stroke small{.from = point, .segments = stroke.segments};
    for (scene::Segment& segment : small.segments)
        segment = {.cubic = segment.cubic,
                   .c1 = segment.cubic ? point : segment.c1,
                   .c2 = segment.cubic ? point : segment.c2,
                   .to = point};
    return small;
}

/// Appends letters to two drawings.
class LetterMatch {
public:
    /// With `hides`, what has no partner is drawn together where another line ends, which hides the caps of
    /// its stroke.
    explicit LetterMatch(bool hides) : hides_{hides} {}

    /// Either may be empty, not both. False if there are too many points.
    bool add(Letter a, Letter b)
    {
        for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
            if (i >= a.size())
                add_alone(b[i], a.empty() ? b : a, matched_.to, matched_.from);
            else if (i >= b.size())
                add_alone(a[i], b.empty() ? a : b, matched_.from, matched_.to);
            else if (!add(a[i], b[i]))
                return false;
        }
        return point_count(matched_.from) <= kfb::max_drawing_points;
    }

    MatchedDrawings take() { return std::move(matched_); }

private:
    bool add(const scene::Stroke& a, const scene::Stroke& b)
    {
        const auto both = match_by_length({{a}}, {{b}}, Reversal::forbidden);
        if (!both)
            return false;
        matched_.from.strokes.push_back(both->from.strokes.front());
        matched_.to.strokes.push_back(both->to.strokes.front());
        return true;
    }

    void add_alone(const scene::Stroke& stroke, Letter centred, scene::Drawing& own, scene::Drawing& other)
    {
        const bool is_hidden = hides_ && !other.strokes.empty();
        own.strokes.push_back(stroke);
        other.strokes.push_back(
            drawn_together(stroke, is_hidden ? end_of(other.strokes.back()) : centre_of(centred)));
    }

    static scene::Point end_of(const scene::Stroke& stroke)
    {
        return stroke.segments.empty() ? stroke.from : stroke.segments.back().to;
    }

    bool hides_;
    MatchedDrawings matched_;
};

}

std::optional<MatchedDrawings> match_by_letters(const scene::Key& a, const scene::Key& b, bool is_stroked)
{
    const std::vector<Letter> from = letters_of(a);
    const std::vector<Letter> to = letters_of(b);
    LetterMatch match{is_stroked && !from.empty() && !to.empty()};
    for (std::size_t i = 0; i < std::max(from.size(), to.size()); ++i)
        if (!match.add(i < from.size() ? from[i] : Letter{}, i < to.size() ? to[i] : Letter{}))
            return std::nullopt;
    return match.take();
}

std::optional<MatchedDrawings> matched_drawings(const scene::Key& key, const scene::Key& next,
                                                bool is_stroked)
{
    switch (key.match) {
    case scene::Match::count:
        break;
    case scene::Match::length:
        return match_by_length(key.drawing, next.drawing);
    case scene::Match::letters:
        return match_by_letters(key, next, is_stroked);
    }
    return MatchedDrawings{key.drawing, next.drawing};
}

}
