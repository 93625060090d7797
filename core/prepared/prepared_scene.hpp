#pragma once

#include "core/prepared/key_timeline.hpp"
#include "core/prepared/node.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// An item as the scene stores it: what is read of it seldom. `node` is neither that of a symbol nor of the
/// scene.
ItemView item_view(const SceneView& scene, const Node& node);

/// A scene laid out in flat arrays, in memory that the caller lends, and moved from moment to moment: nothing
/// is parsed any more, and keys are read when they are passed.
///
///     timelines   key times, each set once             KeyTimeline
///     tracks      values at the two keys around        TrackState, of items, of objects' keys, of bones
///     nodes       items in the order of the scene      Node
///     bones       of all skeletons                     BoneNode
///     levels      room for one walk at a time          WalkLevel
class PreparedScene {
public:
    /// What its memory takes, a multiple of 4.
    static std::size_t bytes_for(const SceneView& scene);

    PreparedScene() = default;
    /// At no moment yet. `memory`, aligned as words are, has bytes_for(scene); it and `scene`'s bytes must
    /// outlive this.
    PreparedScene(const SceneView& scene, std::span<std::byte> memory);

    /// `changed_inputs` has a bit for each input that is no number and was given a new value.
    void move_to(const SceneView& scene, const SceneTime& moment, std::uint32_t changed_inputs);
    /// What has moved since the moment before.
    const Dependence& moved() const { return moved_; }

    /// Of a track that is smooth and has a timeline: part of fine_value(), for the feature.
    std::int32_t smooth_value(const SceneView& scene, const TrackState& track) const;

    std::span<const Node> nodes() const { return nodes_; }
    /// Of the scene itself: the outermost items lie within it.
    const Node& root() const { return nodes_[root_]; }
    /// Within which the items of a group or of a used symbol lie.
    const Node& inside(const Node& node) const { return node.kind == ItemKind::use ? nodes_[node.of] : node; }
    std::span<const BoneNode> bones() const { return bones_; }
    std::span<WalkLevel> levels() const { return levels_; }

    /// Of its properties, in their order.
    std::span<const TrackState> tracks(const Node& node) const
    {
        return tracks_.subspan(node.first_track, node.track_count);
    }
    std::span<const TrackState> tracks(const BoneNode& bone) const
    {
        return tracks_.subspan(bone.first_track, bone.track_count);
    }
    /// Of an object's keys; it has them.
    const TrackState& key_track(const Node& node, KeyValue value) const;

    /// The two values between which a track is, and the way from one to the other; not of a smooth one.
    KeySpan key_span(const TrackState& track, LawAxis axis) const
    {
        return {track.from, track.to,
                track.has_timeline() ? timelines_[track.timeline].progress(axis) : Progress{}};
    }
    ProgressXY progress(const TrackState& track) const
    {
        return track.has_timeline() ? timelines_[track.timeline].progress() : ProgressXY{};
    }
    /// It stays as it is up to the next key. `scene` has its laws.
    bool is_held(const SceneView& scene, const TrackState& track) const
    {
        return track.has_timeline() && timelines_[track.timeline].is_held(scene);
    }
    /// What a track of a property comes to, in 1/256 of its unit. `scene` has its values.
    std::int32_t fine_value(const SceneView& scene, const TrackState& track) const;

    /// What moves a track.
    Dependence dependence(const TrackState& track) const;
    /// To what drawing the way leads from the key before the moment, as an offset.
    std::int32_t arrival(const Node& node) const
    {
        return node.has_arrivals ? key_track(node, KeyValue::arrival).from
                                 : key_track(node, KeyValue::drawing).to;
    }
    /// An object has it on the whole way from key to key, carried by the same bones.
    bool has_one_drawing(const Node& node) const;
    /// What moves the points of an object besides its place: keys and skeletons.
    Dependence dependence_of_strokes(const Node& node) const;
    /// What moves the text or the drawing of an input.
    Dependence dependence_of_input(std::uint32_t number) const
    {
        return {.keys = Dependence::bit(static_cast<std::uint32_t>(timelines_.size()) + number)};
    }

private:
    void take_keys(const SceneView& scene);
    Dependence dependence_of_bones(const Node& node) const;

    std::span<KeyTimeline> timelines_;
    std::span<TrackState> tracks_;
    std::span<Node> nodes_;
    std::span<BoneNode> bones_;
    std::span<WalkLevel> levels_;
    std::uint16_t root_ = 0;
    Dependence moved_;
};

}
