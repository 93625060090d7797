#include "host/scene/skeleton/reach_keys.hpp"

#include "core/math/angle.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/skeleton/reach_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kfast::scene {
namespace {

/// In pixels. The rest up to 1/16 is left to the player, whose angles are rounded.
constexpr double tolerance = 3.0 / 64;
constexpr double promised = 1.0 / 16;
constexpr std::int32_t max_samples = 32; ///< between two keys

/// The angles of both bones, each in the frame of its parent; modulo one turn.
struct ArmKey {
    Time time;
    std::int32_t upper;
    std::int32_t lower;
};

/// Interpolates by the shorter way round.
double between(std::int32_t from, std::int32_t to, double share)
{
    return from + share * shortest_turn(BinaryAngle::from_raw(from), BinaryAngle::from_raw(to));
}

/// Of both bones, rounded angles move the tip by up to this: half a unit each.
double lost_by_rounding(const Arm& arm)
{
    const double reach = distance({}, arm.joint) + 2 * arm.lower_length;
    return reach * std::numbers::pi / BinaryAngle::turn;
}

/// Follows a reach through time, with each step as long as linear interpolation of the angles allows.
class ReachTracer {
public:
    ReachTracer(const std::vector<Bone>& bones, const Reach& reach) : bones_{bones}, reach_{reach}
    {
        find_stops();
    }

    /// Returns more than max_keys if it takes too many.
    std::vector<ArmKey> keys()
    {
        std::vector<ArmKey> keys{key_at(reach_.begin())};
        for (const Time stop : stops_)
            while (keys.back().time < stop && keys.size() <= max_keys)
                keys.push_back(key_at(next_time(keys.back(), stop)));
        return keys;
    }

private:
    /// The motions of all that moves the arm have their corners at these times.
    void find_stops()
    {
        for (const ReachTarget& target : reach_.targets)
            stops_.push_back(target.time);
        const Bone& lower = bones_[reach_.bone];
        const Bone& upper = bones_[*lower.parent];
        add_stops(lower, BoneQuantity::x);
        add_stops(upper, BoneQuantity::x);
        for (auto at = upper.parent; at; at = bones_[*at].parent)
            add_stops(bones_[*at], BoneQuantity::angle);
        std::erase_if(stops_, [&](Time time) { return time <= reach_.begin() || time > reach_.end(); });
        std::ranges::sort(stops_);
    }

    void add_stops(const Bone& bone, BoneQuantity first)
    {
        for (auto i = static_cast<std::size_t>(first); i < bone_quantity_count; ++i)
            for (const TrackKey& key : bone.keys[i])
                stops_.push_back(key.time);
    }

    ArmKey key_at(Time time) const
    {
        const ArmAngles angles =
            angles_reaching(arm_at(bones_, reach_.bone, time), target_at(reach_, time), reach_.bend);
        return {time, static_cast<std::int32_t>(std::lround(angles.upper)),
                static_cast<std::int32_t>(std::lround(angles.lower))};
    }

    /// As late as possible; preferably on a whole frame, which takes fewer bytes.
    Time next_time(const ArmKey& from, Time stop)
    {
        const std::int32_t ticks = longest_step(from, (stop - from.time).ticks);
        step_ = ticks;
        const Time next = from.time + Time{ticks};
        const Time frame{next.ticks / Time::ticks_per_frame * Time::ticks_per_frame};
        return next != stop && frame > from.time ? frame : next;
    }

    /// Doubles the step before, then halves the rest. There is no time within a step of one tick.
    std::int32_t longest_step(const ArmKey& from, std::int32_t max) const
    {
        std::int32_t good = 1;
        std::int32_t bad = max + 1;
        for (std::int32_t step = std::min(step_, max); good < step; step = std::min(2 * step, max)) {
            if (!holds(from, step)) {
                bad = step;
                break;
            }
            good = step;
        }
        while (bad - good > 1) {
            const std::int32_t middle = good + (bad - good) / 2;
            (holds(from, middle) ? good : bad) = middle;
        }
        return good;
    }

    bool holds(const ArmKey& from, std::int32_t ticks) const
    {
        const ArmKey to = key_at(from.time + Time{ticks});
        const std::int32_t steps = std::min(ticks, max_samples + 1);
        for (std::int32_t i = 1; i < steps; ++i)
            if (!holds_at(from, to, Time{static_cast<std::int32_t>(std::int64_t{ticks} * i / steps)}))
                return false;
        return true;
    }

    bool holds_at(const ArmKey& from, const ArmKey& to, Time passed) const
    {
        const Time time = from.time + passed;
        const Arm arm = arm_at(bones_, reach_.bone, time);
        const ArmAngles exact = angles_reaching(arm, target_at(reach_, time), reach_.bend);
        const double share = static_cast<double>(passed.ticks) / (to.time - from.time).ticks;
        const Vec2 tip = arm.tip(between(from.upper, to.upper, share), between(from.lower, to.lower, share));
        return distance(tip, arm.tip(exact.upper, exact.lower)) <=
               std::max(tolerance, tolerance / 2 + lost_by_rounding(arm));
    }

    const std::vector<Bone>& bones_;
    const Reach& reach_;
    std::vector<Time> stops_; ///< in order
    std::int32_t step_ = Time::ticks_per_frame;
};

double missing_at(const Reach& reach, const std::vector<Bone>& bones, Time time)
{
    const Arm arm = arm_at(bones, reach.bone, time);
    const Vec2 target = target_at(reach, time);
    const ArmAngles angles = angles_reaching(arm, target, reach.bend);
    return distance(arm.tip(angles.upper, angles.lower), target);
}

struct Miss {
    double pixels = 0;
    Time time;
    SourceSpan place; ///< of the target that is nearest before it
};

void take_if_worse(Miss& worst, const Reach& reach, const std::vector<Bone>& bones, Time time,
                   SourceSpan place)
{
    const double missing = missing_at(reach, bones, time);
    if (missing > std::max(promised, worst.pixels))
        worst = {missing, time, place};
}

/// The worst of all targets, and of the frames between them; of very many frames it samples only some.
Miss worst_miss(const Reach& reach, const std::vector<Bone>& bones)
{
    constexpr std::int32_t max_frames = 10'000;
    const std::int32_t frames = (reach.end() - reach.begin()).ticks / Time::ticks_per_frame;
    const Time step = Time::frame(frames / max_frames + 1);
    Miss worst;
    for (const ReachTarget& target : reach.targets)
        take_if_worse(worst, reach, bones, target.time, target.place);
    for (std::size_t i = 0; i + 1 < reach.targets.size(); ++i) {
        const std::int32_t first = reach.targets[i].time.ticks / Time::ticks_per_frame + 1;
        for (Time at = Time::frame(first); at < reach.targets[i + 1].time; at = at + step)
            take_if_worse(worst, reach, bones, at, reach.targets[i].place);
    }
    return worst;
}

void warn_of_missed_targets(const Reach& reach, const std::vector<Bone>& bones, SceneContext& context)
{
    const Miss worst = worst_miss(reach, bones);
    if (worst.pixels == 0)
        return;
    context.report.warning(worst.place,
                           "the tip of " + in_quotes(bones[reach.bone].name) +
                               " does not reach its target: at frame " + text_of(worst.time) + ", " +
                               text_of(std::round(worst.pixels * 10) / 10) + " px are missing",
                           "it goes as near as the bones let it; make them longer, or choose other targets");
}

bool is_within(const Reach& reach, Time time) { return time >= reach.begin() && time <= reach.end(); }

bool moves(const Reach& reach, std::size_t bone, const std::vector<Bone>& bones)
{
    return reach.bone == bone || *bones[reach.bone].parent == bone;
}

bool share_a_bone(const Reach& a, const Reach& b, const std::vector<Bone>& bones)
{
    return moves(a, b.bone, bones) || moves(a, *bones[b.bone].parent, bones);
}

bool refuse_other_turns(const Reach& reach, const std::vector<GivenTurn>& turns,
                        const std::vector<Bone>& bones, SceneContext& context)
{
    bool good = true;
    for (const GivenTurn& turn : turns)
        if (moves(reach, turn.bone, bones) && is_within(reach, turn.time))
            good = context.report.error(turn.place,
                                        in_quotes(bones[turn.bone].name) + " is turned by the reach on " +
                                            context.report.line(reach.place) + " at this time",
                                        "leave out turn=…, or let the reach begin later or end earlier");
    return good;
}

/// No input may drive the bones of the reach or their ancestors: the reach itself goes by the time.
bool refuse_inputs(const Reach& reach, const std::vector<Bone>& bones, SceneContext& context)
{
    for (std::optional<std::size_t> bone = reach.bone; bone; bone = bones[*bone].parent)
        if (!bones[*bone].driver.is_time())
            return context.report.error(reach.place,
                                        "this reach goes by the time, but an input moves " +
                                            in_quotes(bones[*bone].name),
                                        "let poses of the input turn the bones of the arm instead");
    return true;
}

bool refuse_overlaps(const std::vector<Reach>& reaches, const std::vector<Bone>& bones, SceneContext& context)
{
    bool good = true;
    for (std::size_t i = 0; i < reaches.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (share_a_bone(reaches[i], reaches[j], bones) && reaches[i].begin() <= reaches[j].end() &&
                reaches[j].begin() <= reaches[i].end())
                good = context.report.error(reaches[i].place,
                                            "the reach on " + context.report.line(reaches[j].place) +
                                                " turns one of these bones at the same time",
                                            "let one of them end before the other begins");
    return good;
}

/// Puts the angles of one bone among its keys. If the bone turns as written, each is the equivalent nearest
/// to the one before.
bool insert_angles(const Reach& reach, const std::vector<ArmKey>& angles, std::int32_t ArmKey::*own,
                   Bone& bone, SceneContext& context)
{
    std::vector<TrackKey>& keys = bone.keys[static_cast<std::size_t>(BoneQuantity::angle)];
    std::erase_if(keys, [&](const TrackKey& key) { return is_within(reach, key.time); });
    auto place = std::ranges::upper_bound(keys, reach.begin(), {}, &TrackKey::time);
    std::int32_t value = place == keys.begin() ? bone.set_up.front() : (place - 1)->value;
    std::vector<TrackKey> inserted;
    for (const ArmKey& key : angles) {
        value += shortest_turn(BinaryAngle::from_raw(value), BinaryAngle::from_raw(key.*own));
        if (!bone.turns_as_written)
            value = BinaryAngle::from_raw(value).raw;
        inserted.push_back({.time = key.time, .laws = {}, .value = value, .place = reach.place});
        if (std::abs(value) > kfb::max_bone_turn)
            return context.report.error(
                reach.place, "to reach its targets, " + in_quotes(bone.name) + " turns round too often",
                "let the skeleton have turns=shortest");
    }
    keys.insert(place, inserted.begin(), inserted.end());
    return true;
}

void add_keys(const Reach& reach, std::vector<Bone>& bones, SceneContext& context)
{
    const std::vector<ArmKey> keys = ReachTracer{bones, reach}.keys();
    if (keys.size() > max_keys) {
        context.report.error(reach.place, "this reach takes more than " + std::to_string(max_keys) + " keys",
                             "let it be shorter, or what moves the bones above it simpler");
        return;
    }
    warn_of_missed_targets(reach, bones, context);
    Bone& lower = bones[reach.bone];
    if (insert_angles(reach, keys, &ArmKey::upper, bones[*lower.parent], context))
        insert_angles(reach, keys, &ArmKey::lower, lower, context);
}

}

void add_reach_keys(std::vector<Reach> reaches, const std::vector<GivenTurn>& turns, std::vector<Bone>& bones,
                    SceneContext& context)
{
    bool good = refuse_overlaps(reaches, bones, context);
    for (const Reach& reach : reaches)
        good =
            refuse_other_turns(reach, turns, bones, context) && refuse_inputs(reach, bones, context) && good;
    if (!good)
        return;
    // Those above move those below.
    std::ranges::stable_sort(reaches, {}, &Reach::bone);
    for (const Reach& reach : reaches)
        add_keys(reach, bones, context);
}

}
