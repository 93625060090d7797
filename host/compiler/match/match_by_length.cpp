#include "host/compiler/match/match_by_length.hpp"

#include "core/math/fixed.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/compiler/match/broken_stroke.hpp"
#include "host/compiler/match/corresponding_places.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace kfast {
namespace {

using Strokes = std::span<const scene::Stroke>;

/// A stroke or the part of a broken one, and its partner; `b` has no segment if that is a single point.
struct MatchedPart {
    AlignedStrokes strokes;
    CorrespondingPlaces places;
};

std::vector<StrokePlace> vertex_places(const MeasuredStroke& stroke)
{
    std::vector<StrokePlace> places(stroke.size() + 1);
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i].segment = i;
    return places;
}

MatchedPart matched(AlignedStrokes strokes)
{
    CorrespondingPlaces places = corresponding_places(strokes);
    return {std::move(strokes), std::move(places)};
}

MatchedPart matched(const MeasuredStroke& part, const MeasuredStroke& partner)
{
    if (partner.empty())
        return {{part, partner}, {vertex_places(part), {}}};
    return matched(aligned_to_part(part, partner));
}

std::vector<MatchedPart> matched_parts(const MeasuredStroke& whole, Strokes partners, Reversal reversal)
{
    if (partners.size() == 1 && !partners[0].segments.empty())
        return {matched(aligned(whole, measured(partners[0]), reversal))};
    std::vector<PartTarget> targets;
    for (const scene::Stroke& partner : partners)
        targets.push_back(target_of(partner));
    const std::vector<MeasuredStroke> parts = broken(whole, targets);
    std::vector<MatchedPart> matches;
    for (std::size_t i = 0; i < parts.size(); ++i)
        matches.push_back(matched(parts[i], measured(partners[i])));
    return matches;
}

/// Adds places, evenly between those that are there, until there are `segments` and one.
std::vector<StrokePlace> spread(const std::vector<StrokePlace>& places, std::size_t segments)
{
    const Distribution pieces{static_cast<std::uint32_t>(segments),
                              static_cast<std::uint32_t>(places.size() - 1)};
    std::vector<StrokePlace> result;
    result.reserve(segments + 1);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const auto [segment, begin] = places[i];
        const double end = places[i + 1].segment == segment ? places[i + 1].share : 1;
        const std::uint32_t count = pieces.at(static_cast<std::uint32_t>(i));
        for (std::uint32_t piece = 0; piece < count; ++piece)
            result.push_back({segment, begin + (end - begin) * piece / count});
    }
    result.push_back(places.back());
    return result;
}

std::size_t max_segments(const std::vector<MatchedPart>& parts)
{
    std::size_t max = 0;
    for (const MatchedPart& part : parts)
        max = std::max(max, part.places.a.size() - 1);
    return max;
}

/// Appends one stroke to `from` and its partners to `to`. All parts get the same number of segments, for that
/// is how equalization breaks a stroke. False if there are too many.
bool append(const scene::Stroke& whole, Strokes partners, Reversal reversal, MatchedDrawings& matched)
{
    std::vector<scene::Stroke>& to = matched.to.strokes;
    if (whole.segments.empty()) {
        matched.from.strokes.push_back(whole);
        to.insert(to.end(), partners.begin(), partners.end());
        return true;
    }
    const std::vector<MatchedPart> parts = matched_parts(measured(whole), partners, reversal);
    const std::size_t segments = max_segments(parts);
    if (segments * parts.size() >= kfb::max_drawing_points)
        return false;
    MeasuredStroke joined;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto& [strokes, places] = parts[i];
        const MeasuredStroke part = divided(strokes.a, spread(places.a, segments));
        joined.insert(joined.end(), part.begin(), part.end());
        to.push_back(strokes.b.empty() ? partners[i]
                                       : rounded(divided(strokes.b, spread(places.b, segments))));
    }
    matched.from.strokes.push_back(rounded(joined));
    return true;
}

bool fits(const scene::Drawing& drawing) { return point_count(drawing) <= kfb::max_drawing_points; }

/// `few` has a stroke, and `many` has as many or more.
std::optional<MatchedDrawings> matched(const scene::Drawing& few, const scene::Drawing& many,
                                       Reversal reversal)
{
    const Distribution parts{static_cast<std::uint32_t>(many.strokes.size()),
                             static_cast<std::uint32_t>(few.strokes.size())};
    if (many.strokes.size() != 1)
        reversal = Reversal::forbidden;
    MatchedDrawings result;
    Strokes partners{many.strokes};
    for (std::uint32_t i = 0; i < few.strokes.size(); ++i) {
        if (!append(few.strokes[i], partners.first(parts.at(i)), reversal, result))
            return std::nullopt;
        partners = partners.subspan(parts.at(i));
    }
    if (!fits(result.from) || !fits(result.to))
        return std::nullopt;
    return result;
}

}

std::optional<MatchedDrawings> match_by_length(const scene::Drawing& a, const scene::Drawing& b,
                                               Reversal reversal)
{
    if (a.strokes.empty() || b.strokes.empty())
        return MatchedDrawings{a, b};
    if (a.strokes.size() <= b.strokes.size())
        return matched(a, b, reversal);
    std::optional<MatchedDrawings> turned = matched(b, a, reversal);
    if (turned)
        std::swap(turned->from, turned->to);
    return turned;
}

}
