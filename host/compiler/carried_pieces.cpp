#include "host/compiler/carried_pieces.hpp"

#include "core/equalize.hpp"
#include "core/key_interval.hpp"
#include "host/compiler/curve_pieces.hpp"
#include "host/compiler/model_reader.hpp"

#include <algorithm>
#include <vector>

namespace kfast {
namespace {

/// What bends may grow by between two moments that are looked at.
constexpr double margin = 1.05;

std::vector<Time> moments_of(const WayTimes& times, const BackboneTimeline& backbones)
{
    constexpr std::int32_t most = 200;
    const std::int32_t step = std::max(Time::ticks_per_frame, (times.until - times.since).ticks / most + 1);
    std::vector<Time> moments;
    for (std::int32_t ticks = times.since.ticks; ticks < times.until.ticks; ticks += step)
        moments.push_back({ticks});
    for (const Time time : backbones.key_times())
        if (time > times.since && time < times.until)
            moments.push_back(time);
    moments.push_back(times.until);
    return moments;
}

bool has_curve(const scene::Drawing& drawing)
{
    return std::ranges::any_of(drawing.strokes, [](const scene::Stroke& stroke) {
        return std::ranges::any_of(stroke.segments, &scene::Segment::cubic);
    });
}

double most_bend(const MatchedDrawings& ends, const LiveBackbones& backbones, Progress way)
{
    double most = 0;
    EqualizedPair pair{ModelReader{ends.from}, ModelReader{ends.to}};
    while (const std::uint32_t segments = pair.next_stroke())
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Pair<Segment> both = pair.next_segment();
            most = std::max(most, bend_of(backbones.between(both.a, both.b, way)));
        }
    return most;
}

}

std::uint32_t carried_curve_pieces(const KeyWay& way, const WayTimes& times,
                                   const BackboneTimeline& backbones, std::uint32_t unit_bits, double scale)
{
    if (!has_curve(way.ends.from))
        return 1;
    double most = 0;
    std::vector<BackboneNode> nodes(backbones.node_count());
    for (const Time moment : moments_of(times, backbones)) {
        const Progress progress = progress_between(way.time, times.next, moment, way.laws);
        most = std::max(most, most_bend(way.ends, backbones.at(moment, unit_bits, nodes), progress));
    }
    return pieces_for_bend(margin * most, scale);
}

}
