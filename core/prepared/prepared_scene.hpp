#pragma once

#include "core/prepared/key_timeline.hpp"
#include "core/scene/item_view.hpp"
#include "core/scene/property.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

// Offsets are those of SceneView::place_of(), not pointers: the records are of one size on all machines.

/// One quantity of an item, an object's keys or a bone: its stored values at the two keys around the
/// current time.
struct TrackState {
    static constexpr std::uint16_t no_timeline = 0xFFFF;

    std::uint32_t values = 0; ///< the offset of all of them (PackedValues); only with a timeline
    std::int32_t from = 0;
    std::int32_t to = 0;                  ///< without a timeline the same
    std::uint16_t timeline = no_timeline; ///< the number of the timeline by which it goes
    std::uint8_t property = 0;            ///< a Property or BoneQuantity, or for an object's keys a KeyValue
    bool is_smooth = false;               ///< TrackView::is_smooth

    bool has_timeline() const { return timeline != no_timeline; }
};

/// What the keys of an object have, in the order of its tracks after those of its properties. All have a
/// drawing; if backbones deform it, it has neither bones nor depths.
enum class KeyValue : std::uint8_t { drawing, arrival, more, backbones };

/// An item that a scene stores, or a symbol, or the scene itself, ready to be evaluated. All are in one
/// array, each before its contents: symbols, then the scene.
struct Node {
    std::uint32_t place = 0; ///< offset of its beginning in the scene's bytes; 0 for symbols and the scene
    std::uint16_t end = 0;   ///< the number of the node after all that is within it
    std::uint16_t first_track = 0;
    /// For a use the number of the symbol's node, for a live item that of the input, for one that bones
    /// deform that of the first bone.
    std::uint16_t of = 0;
    std::uint8_t track_count = 0; ///< the number of properties
    ItemKind kind = ItemKind::group;
    InputLeaf live = InputLeaf::drawing; ///< only for live items
    Deformer deformer = Deformer::none;  ///< this and the rest only for an object
    std::uint8_t unit_bits = 0;          ///< BackbonesView::unit_bits
    std::uint8_t bone_count = 0;         ///< of its skeleton
    bool has_arrivals : 1 = false;
    bool has_depths : 1 = false;
    bool is_placed : 1 = false; ///< whether some track moves, rotates or scales it
    bool has_path : 1 = false;  ///< whether the pivot follows one
    /// Its opacity has to apply to its finished picture. A single layer is made transparent by its colour, in
    /// however many groups and symbols it is alone.
    bool has_several_layers : 1 = false;
    bool is_ordered : 1 = false; ///< whether an item directly inside it has an order
    bool is_cut : 1 = false;     ///< whether some track says that its strokes are drawn in part, or dashed
    ObjectStyle style;           ///< also for live items

    bool is_leaf() const { return kind == ItemKind::object || kind == ItemKind::live; }
    /// Its keys have KeyValue::more, see Key::more.
    bool has_more() const { return has_depths || deformer == Deformer::bones; }
};

/// A bone that a scene stores, ready to be posed.
struct BoneNode {
    std::uint32_t place = 0; ///< offset of its beginning in the scene's bytes
    std::uint16_t first_track = 0;
    std::uint16_t parent = 0; ///< 0 for a root, else the number of an earlier bone of the scene + 1
    std::uint8_t track_count = 0;
    Dependence dependence; ///< what it and its parents depend on
};

static_assert(sizeof(TrackState) == 16 && sizeof(Node) == 32 && sizeof(BoneNode) == 20);
static_assert(alignof(TrackState) == 4 && alignof(Node) == 4 && alignof(BoneNode) == 4);

/// A node on the way from the scene to the node at which a walk (SceneWalk) is. Of one size on all
/// machines, as nodes are.
struct WalkLevel {
    std::uint16_t node = 0;  ///< its number
    std::uint16_t first = 0; ///< the first node within it
    std::uint16_t next = 0;
    std::uint16_t end = 0;
    std::uint8_t opacity = 255;  ///< of its picture if it is blended, otherwise of everything within it
    std::uint8_t placed = 0;     ///< how many have spaces of their own, it and those around it
    bool has_space : 1 = false;  ///< whether the space of the last one of these is computed
    bool is_ordered : 1 = false; ///< whether some of the nodes within it have an order
    bool is_blended : 1 = false; ///< whether it is blended as a whole
    bool is_to_come = false;     ///< whether it is a leaf that has not been visited yet
    std::int32_t order = 0;      ///< of the nodes that are passed now
    std::int32_t next_order = 0; ///< the lowest above it, of those passed
    std::uint32_t path = 0;      ///< see SceneWalk::path()
    Dependence dependence{};     ///< what moves it as a whole
};

static_assert(sizeof(WalkLevel) == 32 && alignof(WalkLevel) == 4);

/// An item as the scene stores it, for what is seldom read. `node` is neither that of a symbol nor of the
/// scene.
ItemView item_view(const SceneView& scene, const Node& node);

/// A scene laid out in flat arrays, in memory that the caller lends, and moved from time to time: nothing
/// is parsed any more, and keys are read when they are passed.
///
///     timelines   key times, each set once             KeyTimeline
///     tracks      values at the two keys around        TrackState, of items, of objects' keys, of bones
///     nodes       items in the order of the scene      Node
///     bones       of all skeletons                     BoneNode
///     levels      room for one walk at a time          WalkLevel
///     clocks      what each of them shows              Time
class PreparedScene {
public:
    /// The size of its memory, a multiple of 4.
    static std::size_t bytes_for(const SceneView& scene);

    PreparedScene() = default;
    /// At no time yet. `memory`, aligned as words are, has bytes_for(scene); it and `scene`'s bytes must
    /// outlive this.
    PreparedScene(const SceneView& scene, std::span<std::byte> memory);

    /// `moment` has the time and the inputs. `changed_inputs` has a bit for each input that was given a new
    /// value.
    void move_to(const SceneView& scene, const SceneTime& moment, std::uint32_t changed_inputs);
    /// What the clocks of the scene show.
    std::span<const Time> clocks() const { return clocks_; }
    /// What has moved since the time before.
    const Dependence& moved() const { return moved_; }

    /// The value of a track that is smooth and has a timeline: part of fine_value(), for the feature.
    std::int32_t smooth_value(const SceneView& scene, const TrackState& track) const;

    std::span<const Node> nodes() const { return nodes_; }
    /// The node of the scene itself: the outermost items are within it.
    const Node& root() const { return nodes_[root_]; }
    /// The node within which the items of a group or of a used symbol are.
    const Node& inside(const Node& node) const { return node.kind == ItemKind::use ? nodes_[node.of] : node; }
    std::span<const BoneNode> bones() const { return bones_; }
    std::span<WalkLevel> levels() const { return levels_; }

    /// The tracks of its properties, in their order.
    std::span<const TrackState> tracks(const Node& node) const
    {
        return tracks_.subspan(node.first_track, node.track_count);
    }
    std::span<const TrackState> tracks(const BoneNode& bone) const
    {
        return tracks_.subspan(bone.first_track, bone.track_count);
    }
    /// A track of an object's keys; it must have it.
    const TrackState& key_track(const Node& node, KeyValue value) const;

    /// The two values between which a track is, and the progress from one to the other; not for a smooth one.
    KeySpan key_span(const TrackState& track, LawAxis axis) const
    {
        return {track.from, track.to,
                track.has_timeline() ? timelines_[track.timeline].progress(axis) : Progress{}};
    }
    ProgressXY progress(const TrackState& track) const
    {
        return track.has_timeline() ? timelines_[track.timeline].progress() : ProgressXY{};
    }
    /// Whether it does not change up to the next key. `scene` has its laws.
    bool is_held(const SceneView& scene, const TrackState& track) const
    {
        return track.has_timeline() && timelines_[track.timeline].is_held(scene);
    }
    /// The value of a track of a property, in 1/256 of its unit. `scene` has its values.
    std::int32_t fine_value(const SceneView& scene, const TrackState& track) const;

    /// What a track depends on.
    Dependence dependence(const TrackState& track) const;
    /// The drawing that the interval from the key before the time leads to, as an offset.
    std::int32_t arrival(const Node& node) const
    {
        return node.has_arrivals ? key_track(node, KeyValue::arrival).from
                                 : key_track(node, KeyValue::drawing).to;
    }
    /// Whether an object has one drawing all the way from key to key, with the same skin or depths.
    bool has_one_drawing(const Node& node) const;
    /// What the points of an object depend on besides its placement: keys and skeletons.
    Dependence dependence_of_strokes(const Node& node) const;
    /// What the text, the number or the drawing of an input depends on.
    Dependence dependence_of_input(std::uint32_t number) const
    {
        return {.keys = Dependence::bit(static_cast<std::uint32_t>(timelines_.size()) + number)};
    }

private:
    void set_clocks(const SceneView& scene, const SceneTime& moment);
    void take_keys(const SceneView& scene);
    Dependence dependence_of_bones(const Node& node) const;

    std::span<KeyTimeline> timelines_;
    std::span<TrackState> tracks_;
    std::span<Node> nodes_;
    std::span<BoneNode> bones_;
    std::span<WalkLevel> levels_;
    std::span<Time> clocks_;
    std::uint16_t root_ = 0;
    Dependence moved_;
};

}
