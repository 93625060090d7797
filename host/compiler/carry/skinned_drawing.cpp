#include "host/compiler/carry/skinned_drawing.hpp"

#include "core/math/fixed.hpp"
#include "core/pose/equalize.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/compiler/match/match_by_count.hpp"
#include "host/scene/skeleton/binding.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace kfast {
namespace {

/// Rounded to 1/16 px, halves up.
scene::Point rounded(Point point)
{
    constexpr std::int32_t unit = Fixed::one / 16;
    const auto sixteenths = [](Fixed value) {
        return static_cast<std::int16_t>((value.raw() + unit / 2) >> 12);
    };
    static_assert(unit == 1 << 12);
    return {sixteenths(point.x), sixteenths(point.y)};
}

scene::Segment stored(const Segment& segment)
{
    if (segment.kind == Segment::Kind::line)
        return {.cubic = false, .c1 = {}, .c2 = {}, .to = rounded(segment.to)};
    return {.cubic = true, .c1 = rounded(segment.c1), .c2 = rounded(segment.c2), .to = rounded(segment.to)};
}

/// Adds those of a stroke that is divided into `pieces`; `own` are those of its points before that.
void add_bindings(std::span<const scene::Binding> own, std::uint32_t pieces,
                  std::vector<scene::Binding>& bindings)
{
    bindings.push_back(own.front());
    const auto segments = static_cast<std::uint32_t>(std::max<std::size_t>(own.size() - 1, 1));
    const Distribution distribution{pieces, segments};
    for (std::uint32_t i = 0; i < segments; ++i) {
        const std::uint32_t count = distribution.at(i);
        const scene::Binding& from = own[i];
        const scene::Binding& to = own[std::min<std::size_t>(i + 1, own.size() - 1)];
        for (std::uint32_t piece = 1; piece < count; ++piece)
            bindings.push_back(scene::mixed(from, to, static_cast<double>(piece) / count));
        bindings.push_back(to);
    }
}

bool fits(const scene::Drawing& first, const scene::Drawing& drawing)
{
    std::size_t points = first.strokes.size();
    for (std::size_t i = 0; i < first.strokes.size(); ++i)
        points += std::max(first.strokes[i].segments.size(), drawing.strokes[i].segments.size());
    return points <= kfb::max_drawing_points;
}

SkinnedDrawing divided(const scene::Drawing& first, std::span<const scene::Binding> bindings,
                       const scene::Drawing& drawing)
{
    SkinnedDrawing result;
    scene::Drawing& at_rest = result.at_rest.emplace();
    EqualizedPair pair{ModelReader{first}, ModelReader{drawing}};
    for (std::size_t i = 0; i < first.strokes.size(); ++i) {
        const std::size_t points = first.strokes[i].segments.size() + 1;
        const std::uint32_t segments = pair.next_stroke();
        scene::Stroke& rest = at_rest.strokes.emplace_back();
        scene::Stroke& own = result.drawing.strokes.emplace_back();
        rest.from = first.strokes[i].from;
        own.from = drawing.strokes[i].from;
        for (std::uint32_t segment = 0; segment < segments; ++segment) {
            const Pair<Segment>& both = pair.next_segment();
            rest.segments.push_back(stored(both.a));
            own.segments.push_back(stored(both.b));
        }
        add_bindings(bindings.first(points), segments, result.bindings);
        bindings = bindings.subspan(points);
    }
    return result;
}

}

std::optional<SkinnedDrawing> skinned_drawing(const scene::Drawing& first,
                                              const std::vector<scene::Binding>& bindings,
                                              const scene::Drawing& drawing)
{
    if (drawing.strokes.empty())
        return SkinnedDrawing{};
    if (drawing == first)
        return SkinnedDrawing{drawing, {}, bindings};
    if (!fits(first, drawing))
        return std::nullopt;
    return divided(first, bindings, drawing);
}

}
