#pragma once

#include "core/prepared/key_timeline.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/scene/scene_view.hpp"

#include <cstdint>
#include <span>

namespace kfast {

/// Lays out a scene in flat arrays: walks once through all that it stores, through a symbol once however
/// often it is used. Without room it only counts what would be needed.
class Preparer {
public:
    struct Room {
        std::span<KeyTimeline> timelines{};
        std::span<TrackState> tracks{};
        std::span<Node> nodes{};
        std::span<BoneNode> bones{};
    };

    /// `scene` has been checked.
    Preparer(const SceneView& scene, const Room& room) : scene_{scene}, room_{room} {}

    void run();
    /// Part of it, for the feature.
    [[gnu::cold]] void add_skeletons();
    /// Valid afterwards.
    const SceneRecords& records() const { return records_; }
    /// The number of keys of all timelines.
    std::uint32_t keys() const { return keys_; }
    /// The number of the scene's own node, the last one that is no item's.
    std::uint32_t root() const { return root_; }

private:
    /// The items of a list, and the node that they are in.
    struct Level {
        ItemCursor items{ByteReader{{}}};
        std::uint32_t node = 0;
    };

    [[gnu::cold]] void add_bones(const SkeletonView& skeleton, std::uint32_t first);
    void add_symbols();
    std::uint32_t add_root(ItemCursor items);
    std::uint32_t add_item(const ItemView& item, std::uint32_t around);
    std::uint32_t add_node(const Node& node);
    Node node_of(const ItemView& item) const;
    std::uint16_t symbol_node(std::uint32_t symbol) const;
    bool add_tracks(const ItemView& item, Node& node);
    void add_keys(const ObjectView& object);
    void add_track(std::uint8_t property, const KeyTimeCursor& key_times, const PackedValues& values,
                   bool is_smooth = false);
    void add_track(const TrackState& track);
    std::uint16_t timeline_of(const KeyTimeCursor& key_times, bool is_smooth);
    bool has_several_layers(std::uint32_t number, const Node& node) const;
    void finish(std::uint32_t number);

    const SceneView& scene_;
    Room room_;
    SceneRecords records_;
    std::uint32_t root_ = 0;
    std::uint32_t keys_ = 0;
    std::uint32_t key_times_ = 0;                      ///< the offset of those that were met last
    std::uint16_t timeline_ = TrackState::no_timeline; ///< theirs
};

}
