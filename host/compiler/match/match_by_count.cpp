#include "host/compiler/match/match_by_count.hpp"

#include "core/math/fixed.hpp"

#include <algorithm>
#include <utility>

namespace kfast {

namespace {

/// How many parts the strokes of the drawing with fewer strokes break into.
Distribution parts_of_strokes(const scene::Drawing& a, const scene::Drawing& b)
{
    const auto strokes = [](const scene::Drawing& drawing, const scene::Drawing& partner) {
        return static_cast<std::uint32_t>(drawing.strokes.empty() ? partner.strokes.size()
                                                                  : drawing.strokes.size());
    };
    const std::uint32_t of_a = strokes(a, b);
    const std::uint32_t of_b = strokes(b, a);
    return {std::max(of_a, of_b), std::max<std::uint32_t>(std::min(of_a, of_b), 1)};
}

/// Divides segments evenly, the first ones into one piece more, until there are `count`.
std::vector<Segment> spread(const std::vector<Segment>& segments, std::size_t count)
{
    const Distribution pieces{static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(segments.size())};
    std::vector<Segment> result;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        const std::uint32_t of_segment = pieces.at(i);
        for (std::uint32_t piece = 0; piece < of_segment; ++piece)
            result.push_back(subsegment(segments[i], Fraction::ratio(piece, of_segment),
                                        Fraction::ratio(piece + 1, of_segment)));
    }
    return result;
}

}

std::vector<Segment> side_of(const SegmentPairs& pairs, Segment Pair<Segment>::*side)
{
    std::vector<Segment> segments;
    for (const Pair<Segment>& both : pairs)
        segments.push_back(both.*side);
    return segments;
}

MatchedSegments match_by_count(const scene::Drawing& a, const scene::Drawing& b)
{
    const Distribution parts = parts_of_strokes(a, b);
    MatchedSegments matched;
    matched.breaks_b = !b.strokes.empty() && b.strokes.size() < a.strokes.size();
    EqualizedPair pair{ModelReader{a}, ModelReader{b}};
    while (const std::uint32_t segments = pair.next_stroke()) {
        auto& strokes = matched.strokes;
        if (strokes.empty() ||
            strokes.back().size() == parts.at(static_cast<std::uint32_t>(strokes.size() - 1)))
            strokes.emplace_back();
        SegmentPairs& part = strokes.back().emplace_back();
        for (std::uint32_t i = 0; i < segments; ++i)
            part.push_back(pair.next_segment());
    }
    return matched;
}

Pair<SegmentDrawing> joined(const MatchedSegments& matched)
{
    SegmentDrawing few;
    SegmentDrawing many;
    const auto of_few = matched.breaks_b ? &Pair<Segment>::b : &Pair<Segment>::a;
    const auto of_many = matched.breaks_b ? &Pair<Segment>::a : &Pair<Segment>::b;
    for (const std::vector<SegmentPairs>& parts : matched.strokes) {
        const std::size_t segments = std::ranges::max_element(parts, {}, &SegmentPairs::size)->size();
        std::vector<Segment>& whole = few.emplace_back();
        for (const SegmentPairs& part : parts) {
            const std::vector<Segment> added = spread(side_of(part, of_few), segments);
            whole.insert(whole.end(), added.begin(), added.end());
            many.push_back(spread(side_of(part, of_many), segments));
        }
    }
    if (matched.breaks_b)
        return {std::move(many), std::move(few)};
    return {std::move(few), std::move(many)};
}

}
