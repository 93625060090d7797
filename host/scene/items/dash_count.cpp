#include "host/scene/items/dash_count.hpp"

#include "core/features.hpp"
#include "core/time/spring_law.hpp"
#include "core/time/track.hpp"
#include "host/geometry/outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kfast::scene {
namespace {

constexpr int moments = 1024; ///< of a transition that are looked at

struct ShareXY {
    double x = 0;
    double y = 0;
};

/// How far a transition is at one of its moments; below 0 or above 1 where its laws go beyond the keys.
ShareXY progress_at(int moment, const LawPair& laws)
{
    const SpringFeature springs{.progress = spring_progress};
    const ProgressXY progress = progress_between(Time{0}, Time{moments}, Time{moment}, laws, &springs);
    return {progress.x.raw / double{Progress::one}, progress.y.raw / double{Progress::one}};
}

Vec2 pixels(Point at) { return {at.x / 16.0, at.y / 16.0}; }

Vec2 spot_on(Vec2 from, const Segment& segment, double t)
{
    const double s = 1 - t;
    if (!segment.cubic)
        return s * from + t * pixels(segment.to);
    return s * s * s * from + 3 * s * s * t * pixels(segment.c1) + 3 * s * t * t * pixels(segment.c2) +
           t * t * t * pixels(segment.to);
}

double length_of(const Stroke& stroke)
{
    constexpr int chords = 16;
    double length = 0;
    Vec2 from = pixels(stroke.from);
    for (const Segment& segment : stroke.segments) {
        Vec2 last = from;
        for (int i = 1; i <= chords; ++i) {
            const Vec2 to = spot_on(from, segment, i / double{chords});
            length += distance(last, to);
            last = to;
        }
        from = last;
    }
    return length;
}

double length_of(const Drawing& drawing)
{
    double length = 0;
    for (const Stroke& stroke : drawing.strokes)
        length += length_of(stroke);
    return length;
}

double dashes_of(double length, std::size_t strokes, const DashPattern& pattern)
{
    return (std::ceil(length / pattern.period) + 2 * static_cast<double>(strokes) - 1) * pattern.dashes;
}

double dashes_of(const Drawing& drawing, const DashPattern& pattern)
{
    double dashes = 0;
    for (const Stroke& stroke : drawing.strokes)
        dashes += dashes_of(length_of(stroke), 1, pattern);
    return dashes;
}

/// How long what is between two lengths may be, where points of one go to points of the other.
double mixed(double from, double to, double share)
{
    return std::abs(1 - share) * from + std::abs(share) * to;
}

/// No drawing on the way to the next key is longer.
double longest_between(double from, double to, const LawPair& laws)
{
    double longest = std::max(from, to);
    for (int moment = 1; moment < moments; ++moment) {
        const ShareXY share = progress_at(moment, laws);
        const double by_x = mixed(from, to, share.x);
        longest = std::max(longest, laws.x == laws.y ? by_x : by_x + mixed(from, to, share.y));
    }
    return longest;
}

std::size_t strokes_between(const Key& from, const Key& to)
{
    const std::size_t a = from.drawing.strokes.size();
    const std::size_t b = to.drawing.strokes.size();
    return from.match == Match::count ? std::max(a, b) : a + b;
}

/// The lengths of a pattern and what they go by.
class PatternKeys {
public:
    explicit PatternKeys(std::span<const Track> tracks)
    {
        for (const Track& track : tracks) {
            if (!is_dash_length(track.property))
                continue;
            lengths_.push_back(track.keys);
            if (track.keys.size() > size())
                keys_ = track.keys;
            const auto index = static_cast<int>(track.property) - static_cast<int>(Property::dash_1);
            dashes_ = std::max(dashes_, index / 2 + 1); // lengths of 0 may have no track
        }
    }

    std::size_t size() const { return keys_.size(); }
    double dashes() const { return dashes_; }
    const TrackKey& key(std::size_t index) const { return keys_[index]; }

    /// Between a key and the next one.
    double period(std::size_t index, double share) const
    {
        double period = 0;
        for (const std::span<const TrackKey> keys : lengths_)
            period += std::max(0.0, std::lerp(value(keys, index), value(keys, index + 1), share));
        return period / dash_pixel;
    }

private:
    /// A track of one key holds its value.
    static double value(std::span<const TrackKey> keys, std::size_t index)
    {
        return keys[std::min(index, keys.size() - 1)].value;
    }

    std::vector<std::span<const TrackKey>> lengths_;
    std::span<const TrackKey> keys_; ///< of the track that has most
    int dashes_ = 0;
};

bool shorten(DashPattern& shortest, double period)
{
    if (period <= 0 || period >= shortest.period)
        return false;
    shortest.period = period;
    return true;
}

}

DashPattern shortest_pattern(std::span<const Track> tracks)
{
    const PatternKeys keys{tracks};
    DashPattern shortest{.dashes = keys.dashes()};
    for (std::size_t i = 0; i < keys.size(); ++i)
        shorten(shortest, keys.period(i, 0));
    return shortest;
}

std::optional<MovedPattern> shortest_pattern_between_keys(std::span<const Track> tracks)
{
    const PatternKeys keys{tracks};
    if (keys.size() < 2)
        return std::nullopt;
    MovedPattern shortest{.pattern = {.dashes = keys.dashes()}, .place = keys.key(1).place};
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
        for (int moment = 1; moment < moments; ++moment)
            if (shorten(shortest.pattern, keys.period(i, progress_at(moment, keys.key(i).laws).x)))
                shortest.place = keys.key(i + 1).place;
    return shortest;
}

double dashes_of(std::span<const Key> keys, const DashPattern& pattern)
{
    double most = 0;
    for (const Key& key : keys)
        most = std::max(most, dashes_of(key.drawing, pattern));
    return most;
}

double dashes_between(std::span<const Key> keys, const DashPattern& pattern)
{
    double most = dashes_of(keys, pattern);
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
        most = std::max(most, dashes_of(longest_between(length_of(keys[i].drawing),
                                                        length_of(keys[i + 1].drawing), keys[i].laws),
                                        strokes_between(keys[i], keys[i + 1]), pattern));
    return most;
}

namespace {

constexpr double growth_of_bends = 2;

/// At keys and between them.
double longest(std::span<const TrackKey> keys)
{
    double longest = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        longest = std::max<double>(longest, keys[i].value);
        for (int moment = 1; i + 1 < keys.size() && moment < moments; ++moment)
            longest = std::max(
                longest, std::lerp(keys[i].value, keys[i + 1].value, progress_at(moment, keys[i].laws).x));
    }
    return longest;
}

const std::vector<TrackKey>& keys_of(const Bone& bone, BoneQuantity quantity)
{
    return bone.keys[static_cast<std::size_t>(quantity)];
}

bool has_moved_origin(const Bone& bone)
{
    return !keys_of(bone, BoneQuantity::x).empty() || !keys_of(bone, BoneQuantity::y).empty();
}

/// Widens a range by the lengths of a line's segments, each of at least a pixel.
struct LengthRange {
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 1;

    void include(Point from, Point to)
    {
        const double length = std::max(distance(pixels(from), pixels(to)), 1.0);
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
    }
};

/// The segment with this index of a line at all keys; `line` is that of a backbone.
double growth_of(std::span<const BackboneKey> keys, std::size_t backbone, std::vector<Point> Backbone::*line,
                 std::size_t segment)
{
    LengthRange range;
    for (const BackboneKey& key : keys) {
        const std::vector<Point>& points = key.backbones[backbone].*line;
        range.include(points[segment], points[segment + 1]);
    }
    return range.longest / range.shortest;
}

}

double growth_by(const Bones& skeleton)
{
    const auto is_root = [](const Bone& bone) { return !bone.parent; };
    const bool is_one_tree = std::ranges::count_if(skeleton.bones, is_root) == 1;
    double stretch = 1;
    for (const Bone& bone : skeleton.bones) {
        if (has_moved_origin(bone) && !(is_root(bone) && is_one_tree))
            return std::numeric_limits<double>::infinity();
        const double length = bone.set_up[static_cast<std::size_t>(BoneQuantity::length)];
        stretch = std::max(stretch, longest(keys_of(bone, BoneQuantity::length)) / length);
    }
    return growth_of_bends * stretch;
}

double growth_by(std::span<const BackboneKey> keys)
{
    double stretch = 1;
    const std::vector<Backbone>& backbones = keys.front().backbones;
    for (std::size_t i = 0; i < backbones.size(); ++i)
        for (const auto line : {&Backbone::nodes, &Backbone::left, &Backbone::right})
            for (std::size_t segment = 0; segment + 1 < (backbones[i].*line).size(); ++segment)
                stretch = std::max(stretch, growth_of(keys, i, line, segment));
    return growth_of_bends * stretch;
}

}
