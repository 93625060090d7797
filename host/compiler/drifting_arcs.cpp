#include "host/compiler/drifting_arcs.hpp"

#include "core/features.hpp"
#include "core/time/track.hpp"
#include "host/compiler/carry/backbone_cells.hpp"
#include "host/compiler/match/match_by_count.hpp"
#include "host/compiler/match/match_by_letters.hpp"
#include "host/text/number_text.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace kfast {
namespace {

using scene::Sector;

constexpr double arc_tolerance = 0.75;   ///< px
constexpr double advised_drift = 0.5;    ///< px; the rest is for rounding
constexpr double chord_error = 0.02;     ///< px by which a chord differs from what is drawn
constexpr std::int32_t max_moments = 16; ///< sampled between two keys
constexpr double degrees_apart = 5;      ///< between sampled points of the arc

double interpolated(double a, double b, double share) { return a + share * (b - a); }

double share_of(Progress progress) { return static_cast<double>(progress.raw) / Progress::one; }

/// The sector as it would be if its angles were interpolated.
Sector interpolated(const Sector& a, const Sector& b, const ProgressXY& progress)
{
    const double x = share_of(progress.x);
    const double y = share_of(progress.y);
    return {.centre = {interpolated(a.centre.x, b.centre.x, x), interpolated(a.centre.y, b.centre.y, y)},
            .radius_x = interpolated(a.radius_x, b.radius_x, x),
            .radius_y = interpolated(a.radius_y, b.radius_y, y),
            .from = interpolated(a.from, b.from, x),
            .to = interpolated(a.to, b.to, x)};
}

std::vector<Vec2> arc_spots(const Sector& sector)
{
    const int count = 1 + static_cast<int>(std::abs(sector.to - sector.from) / degrees_apart);
    std::vector<Vec2> spots;
    for (int i = 0; i <= count; ++i) {
        const double angle = interpolated(sector.from, sector.to, static_cast<double>(i) / count);
        const double turn = angle * std::numbers::pi / 180;
        spots.push_back(sector.centre +
                        Vec2{sector.radius_x * std::cos(turn), sector.radius_y * std::sin(turn)});
    }
    return spots;
}

/// The number of chords of a segment, which is at most a quarter of an ellipse.
std::uint32_t chords_of(double radius)
{
    return 1 + static_cast<std::uint32_t>(std::numbers::pi / 4 * std::sqrt(radius / chord_error / 2));
}

std::vector<Vec2> stroke_spots(const SegmentPairs& stroke, const ProgressXY& progress, std::uint32_t chords)
{
    std::vector<Vec2> spots;
    for (const Pair<Segment>& pair : stroke) {
        const Segment segment = tween(pair.a, pair.b, progress.x, progress.y);
        for (std::uint32_t i = spots.empty() ? 0 : 1; i <= chords; ++i)
            spots.push_back(in_pixels(point_at(segment, Fraction::ratio(i, chords))));
    }
    return spots;
}

double distance_to(const std::vector<Vec2>& line, Vec2 spot)
{
    double nearest = distance(spot, line.front());
    for (std::size_t i = 1; i < line.size(); ++i)
        nearest = std::min(nearest, distance_to_line(spot, line[i - 1], line[i]));
    return nearest;
}

/// How far the points of an arc are from what is drawn instead, in pixels.
double drift(const Sector& sector, const std::vector<Vec2>& drawn)
{
    double farthest = 0;
    for (const Vec2 spot : arc_spots(sector))
        farthest = std::max(farthest, distance_to(drawn, spot));
    return farthest;
}

/// Where an arc is farthest from its circle.
struct Drift {
    double by = 0; ///< px
    Time time;
    SourceSpan place;           ///< of the key that it leaves
    double radius = 0;          ///< px
    bool is_alone_good = false; ///< it would stay on its circle in an object of its own
};

/// The sampled times between two keys: whole frames, or evenly over the range of an input.
std::vector<Time> moments_between(Time from, Time to, bool is_time)
{
    const std::int32_t unit = is_time ? Time::ticks_per_frame : 1;
    const std::int32_t first = from.ticks / unit + 1;
    const std::int32_t last = (to.ticks - 1) / unit;
    const std::int32_t count = std::min(last - first + 1, max_moments);
    std::vector<Time> moments;
    for (std::int32_t i = 0; i < count; ++i) {
        const std::int64_t offset = std::int64_t{last - first} * i / std::max(count - 1, 1);
        moments.push_back({(first + static_cast<std::int32_t>(offset)) * unit});
    }
    return moments;
}

/// What `from` is at the next key if it has other angles there, else null.
const scene::SectorStroke* other_angles(const scene::SectorStroke& from, const scene::Key& next)
{
    const auto to = std::ranges::find(next.sectors, from.stroke, &scene::SectorStroke::stroke);
    const bool is_other =
        to != next.sectors.end() && (from.sector.from != to->sector.from || from.sector.to != to->sector.to);
    return is_other ? &*to : nullptr;
}

class DriftingArcs {
public:
    explicit DriftingArcs(const scene::Object& object) : object_{object} {}

    Drift worst()
    {
        for (std::size_t i = 0; i + 1 < object_.keys.size(); ++i)
            look_at(object_.keys[i], object_.keys[i + 1]);
        return worst_;
    }

private:
    void look_at(const scene::Key& key, const scene::Key& next)
    {
        if (key.sectors.empty() || key.drawing.strokes.size() != next.drawing.strokes.size())
            return;
        if (std::ranges::none_of(key.sectors, [&](const auto& from) { return other_angles(from, next); }))
            return;
        const MatchedDrawings drawings = matched_drawings(key, next, object_.stroke.has_value())
                                             .value_or(MatchedDrawings{key.drawing, next.drawing});
        const MatchedSegments matched = match_by_count(drawings.from, drawings.to);
        for (const scene::SectorStroke& from : key.sectors)
            if (const scene::SectorStroke* const to = other_angles(from, next))
                look_at(key, next, {from, *to}, matched.strokes[from.stroke].front());
    }

    void look_at(const scene::Key& key, const scene::Key& next, const Pair<scene::SectorStroke>& sectors,
                 const SegmentPairs& stroke)
    {
        for (const Time time : moments_between(key.time, next.time, !object_.driver.is_input())) {
            const ProgressXY progress = progress_between(key.time, next.time, time, key.laws, &kfast_springs);
            const Sector sector = interpolated(sectors.a.sector, sectors.b.sector, progress);
            const double radius = std::max(sector.radius_x, sector.radius_y);
            const double by = drift(sector, stroke_spots(stroke, progress, chords_of(radius)));
            if (by > worst_.by)
                worst_ = {by, time, key.place, radius, is_trimmed_alone(sectors)};
        }
    }

    /// Whether trim_sectors() would replace it.
    bool is_trimmed_alone(const Pair<scene::SectorStroke>& sectors) const
    {
        const auto fits = [&](const scene::SectorStroke& stroke) {
            return stroke.form != scene::SectorForm::ring_piece && stroke.form == sectors.a.form &&
                   stroke.sector.radius_x == stroke.sector.radius_y;
        };
        return object_.keys.front().drawing.strokes.size() > 1 && fits(sectors.a) && fits(sectors.b);
    }

    const scene::Object& object_;
    Drift worst_;
};

/// Rounded to a power of ten that is a thousandth of its range or less: for 0 to 4095 a whole number, for 0
/// to 100 one with a digit after the point.
std::string value_text(const scene::Input& input, Time time)
{
    const double share = static_cast<double>(time.ticks) / whole_input.ticks;
    const double min = input.min / 1000.0;
    const double max = input.max / 1000.0;
    const double step = std::pow(10, std::floor(std::log10((max - min) / 1000)));
    return rounded_text(std::round(interpolated(min, max, share) / step) * step);
}

/// "frame 51" or, of an object that an input moves, "level=12.5".
std::string moment_text(const scene::Scene& scene, Driver driver, Time time)
{
    if (driver.is_clock())
        return "frame " + rounded_text(in_frames(time)) + " of its own time";
    if (driver.is_time())
        return "frame " + rounded_text(in_frames(time));
    const scene::Input& input = scene.inputs[driver.index()];
    return input.name + '=' + value_text(input, time);
}

/// How many degrees an end may go from key to key so that a chord stays near its circle.
int step_of(double radius)
{
    const double half = std::acos(1 - std::min(advised_drift / radius, 1.0));
    return std::max(1, static_cast<int>(2 * half * 180 / std::numbers::pi));
}

void warn_of_drift(const scene::Scene& scene, const scene::Object& object, Diagnostics& diagnostics)
{
    const bool is_bent = object.skin || !object.backbone_keys.empty() || object.keys.empty();
    const Drift worst = is_bent ? Drift{} : DriftingArcs{object}.worst();
    if (worst.by < arc_tolerance)
        return;
    diagnostics.warning(worst.place,
                        "the arc leaves its circle on the way to the next key, by " +
                            rounded_text(std::round(worst.by * 10) / 10) + " px at " +
                            moment_text(scene, object.driver, worst.time) + ": points go straight",
                        worst.is_alone_good
                            ? "draw it in an object of its own, where its ends go along the circle"
                            : "add a key for every " + std::to_string(step_of(worst.radius)) +
                                  " degrees or so, with match=length, or turn an arc that keeps its length");
}

void warn_of_drifts(const scene::Scene& scene, const std::vector<scene::Item>& items,
                    Diagnostics& diagnostics)
{
    for (const scene::Item& item : items)
        if (const auto* const group = std::get_if<scene::Group>(&item.content))
            warn_of_drifts(scene, group->items, diagnostics);
        else if (const auto* const object = std::get_if<scene::Object>(&item.content))
            warn_of_drift(scene, *object, diagnostics);
}

}

void warn_of_drifting_arcs(const scene::Scene& scene, Diagnostics& diagnostics)
{
    for (const scene::Symbol& symbol : scene.symbols)
        warn_of_drifts(scene, symbol.items, diagnostics);
    warn_of_drifts(scene, scene.items, diagnostics);
}

}
