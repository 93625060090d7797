#include "core/prepared/prepared_scene.hpp"

#include "core/bytes/bump_allocator.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/features.hpp"
#include "core/prepared/preparer.hpp"
#include "core/time/track.hpp"

namespace kfast {

namespace {

std::size_t timeline_bytes(const SceneView& scene) { return scene.records().timelines * sizeof(KeyTimeline); }
std::size_t track_bytes(const SceneView& scene) { return scene.records().tracks * sizeof(TrackState); }
std::size_t node_bytes(const SceneView& scene) { return scene.records().nodes * sizeof(Node); }
std::size_t bone_bytes(const SceneView& scene) { return scene.records().bones * sizeof(BoneNode); }
std::size_t level_bytes(const SceneView& scene) { return scene.records().levels * sizeof(WalkLevel); }
std::size_t clock_bytes(const SceneView& scene) { return scene.clock_count() * sizeof(Time); }

/// Values as `track` has them stored.
PackedValues values_of(const SceneView& scene, const TrackState& track, std::uint32_t count)
{
    ByteReader bytes = scene.at(track.values);
    return PackedValues::take(bytes, count);
}

bool tweens(Property property) { return property != Property::order && property != Property::visible; }

}

ItemView item_view(const SceneView& scene, const Node& node)
{
    return ItemCursor{scene.at(node.place)}.next();
}

std::size_t PreparedScene::bytes_for(const SceneView& scene)
{
    return timeline_bytes(scene) + track_bytes(scene) + node_bytes(scene) + bone_bytes(scene) +
           level_bytes(scene) + clock_bytes(scene);
}

PreparedScene::PreparedScene(const SceneView& scene, std::span<std::byte> memory)
{
    BumpAllocator cutter{memory};
    timelines_ = cutter.cut_as<KeyTimeline>(timeline_bytes(scene));
    tracks_ = cutter.cut_as<TrackState>(track_bytes(scene));
    nodes_ = cutter.cut_as<Node>(node_bytes(scene));
    bones_ = cutter.cut_as<BoneNode>(bone_bytes(scene));
    levels_ = cutter.cut_as<WalkLevel>(level_bytes(scene));
    clocks_ = cutter.cut_as<Time>(clock_bytes(scene));
    Preparer preparer{scene, {timelines_, tracks_, nodes_, bones_}};
    preparer.run();
    root_ = static_cast<std::uint16_t>(preparer.root());
}

void PreparedScene::move_to(const SceneView& scene, const SceneTime& moment, std::uint32_t changed_inputs)
{
    moved_ = {};
    if (!clocks_.empty())
        set_clocks(scene, moment);
    const SceneTime with_clocks{moment.time(), moment.inputs(), clocks_};
    std::uint32_t number = 0;
    for (KeyTimeline& timeline : timelines_) {
        timeline.move_to(with_clocks.at(timeline.driver()), scene);
        const std::uint32_t bit = Dependence::bit(number++);
        moved_.keys |= timeline.has_other_keys() ? bit : 0;
        moved_.tweens |= timeline.has_moved() ? bit : 0;
    }
    if (moved_.keys != 0)
        take_keys(scene);
    for (std::uint32_t input = 0; changed_inputs != 0; ++input, changed_inputs >>= 1)
        if ((changed_inputs & 1) != 0)
            moved_ = moved_ | dependence_of_input(input);
}

/// A clock goes by the scene's time or by one before it. To measure a scene, `moment` may say what all of
/// them show.
[[gnu::cold, gnu::noinline]] void PreparedScene::set_clocks(const SceneView& scene, const SceneTime& moment)
{
    const SceneTime with_clocks{moment.time(), {}, clocks_};
    const bool is_told = !moment.clocks().empty();
    ClockCursor clocks = scene.clocks();
    std::size_t number = 0;
    for (Time& shown : clocks_) {
        const Clock clock = clocks.next();
        shown = is_told ? moment.at(Driver::of_clock(number)) : clock.at(with_clocks.at(clock.driver));
        ++number;
    }
}

/// Takes over the values for all timelines that have come to other keys.
void PreparedScene::take_keys(const SceneView& scene)
{
    for (TrackState& track : tracks_) {
        if (!track.has_timeline() || !timelines_[track.timeline].has_other_keys())
            continue;
        count_op(Op::key);
        const KeyTimeline& timeline = timelines_[track.timeline];
        const PackedValues values = values_of(scene, track, timeline.key_times(scene).count());
        track.from = values[timeline.from()];
        track.to = timeline.is_between() ? values[timeline.to()] : track.from;
    }
    for (BoneNode& bone : bones_) {
        bone.dependence = bone.parent == 0 ? Dependence{} : bones_[bone.parent - 1U].dependence;
        for (const TrackState& track : tracks(bone))
            bone.dependence = bone.dependence | dependence(track);
    }
}

const TrackState& PreparedScene::key_track(const Node& node, KeyValue value) const
{
    std::size_t number = node.first_track + std::size_t{node.track_count};
    if (value > KeyValue::drawing)
        ++number;
    if (value > KeyValue::arrival && node.has_arrivals)
        ++number;
    return tracks_[number];
}

std::int32_t PreparedScene::fine_value(const SceneView& scene, const TrackState& track) const
{
    if (track.is_smooth && track.has_timeline())
        return scene.features().smooth->value(*this, scene, track);
    const auto property = static_cast<Property>(track.property);
    if (!tweens(property))
        return to_fine(track.from);
    return kfast::fine_value(key_span(track, goes_by_y(property) ? LawAxis::y : LawAxis::x));
}

std::int32_t PreparedScene::smooth_value(const SceneView& scene, const TrackState& track) const
{
    const KeyTimeline& timeline = timelines_[track.timeline];
    if (!timeline.is_between())
        return to_fine(track.from);
    const std::uint32_t count = timeline.key_times(scene).count();
    const PackedValues values = values_of(scene, track, count);
    const std::uint32_t before = timeline.from() == 0 ? 0 : timeline.from() - 1;
    const std::uint32_t after = timeline.to() + 1 == count ? timeline.to() : timeline.to() + 1;
    return hermite({.before = {timeline.time_before(), values[before]},
                    .from = {timeline.from_time(), track.from},
                    .to = {timeline.to_time(), track.to},
                    .after = {timeline.time_after(scene), values[after]}},
                   timeline.now());
}

Dependence PreparedScene::dependence(const TrackState& track) const
{
    if (!track.has_timeline())
        return {};
    const std::uint32_t bit = Dependence::bit(track.timeline);
    const bool is_on_the_way =
        timelines_[track.timeline].is_between() && (track.is_smooth || track.from != track.to);
    return {.keys = bit, .tweens = is_on_the_way ? bit : 0};
}

Dependence PreparedScene::dependence_of_strokes(const Node& node) const
{
    Dependence all = dependence(key_track(node, KeyValue::drawing));
    all.tweens = has_one_drawing(node) ? 0 : all.keys;
    if (node.deformer == Deformer::backbones)
        return all | dependence(key_track(node, KeyValue::backbones));
    if (node.deformer == Deformer::bones)
        return all | dependence_of_bones(node);
    return all;
}

bool PreparedScene::has_one_drawing(const Node& node) const
{
    if (key_track(node, KeyValue::drawing).from != arrival(node))
        return false;
    if (!node.has_more())
        return true;
    const TrackState& more = key_track(node, KeyValue::more);
    return more.from == more.to;
}

/// Of all bones of a skeleton, or of the one to which the drawing is bound.
Dependence PreparedScene::dependence_of_bones(const Node& node) const
{
    const TrackState& skin = key_track(node, KeyValue::more);
    if (skin.from < 0 && skin.from == skin.to)
        return bones_[node.of + SceneView::bone_of(skin.from)].dependence;
    Dependence all;
    for (const BoneNode& bone : bones_.subspan(node.of, node.bone_count))
        all = all | bone.dependence;
    return all;
}

}
