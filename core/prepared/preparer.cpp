#include "core/prepared/preparer.hpp"

#include "core/features.hpp"
#include "core/scene/kfb_limits.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

template <class Record>
void put_at(std::span<Record> room, std::uint32_t number, const Record& record)
{
    if (number < room.size())
        room[number] = record;
}

}

void Preparer::run()
{
    if (!scene_.skeletons().at_end())
        scene_.features().bones->prepare(*this);
    add_symbols();
    root_ = add_root(scene_.items());
}

void Preparer::add_skeletons()
{
    for (SkeletonCursor skeletons = scene_.skeletons(); !skeletons.at_end();)
        add_bones(skeletons.next(), records_.bones);
}

/// `first`: how many bones the previous skeletons have.
void Preparer::add_bones(const SkeletonView& skeleton, std::uint32_t first)
{
    const std::uint16_t common = timeline_of(skeleton.common_key_times(), false);
    for (BoneCursor bones = skeleton.bones(); !bones.at_end();) {
        BoneNode node;
        node.place = scene_.place_of(bones.rest().rest().data());
        node.first_track = static_cast<std::uint16_t>(records_.tracks);
        const BoneView bone = bones.next();
        node.parent = static_cast<std::uint16_t>(bone.parent == 0 ? 0 : first + bone.parent);
        for (std::size_t i = 0; i < bone_quantity_count; ++i) {
            const BoneKeys& keys = bone.keys[i];
            if (keys.kind() == BoneKeys::Kind::none)
                continue;
            if (keys.kind() == BoneKeys::Kind::common) {
                key_times_ = scene_.place_of(skeleton.common_key_times().place());
                timeline_ = common;
            }
            add_track(static_cast<std::uint8_t>(i), keys.keys().key_times(), keys.values());
            ++node.track_count;
        }
        put_at(room_.bones, records_.bones++, node);
    }
}

void Preparer::add_symbols()
{
    for (std::uint32_t number = 0; number < scene_.symbol_count(); ++number)
        add_root(scene_.symbol(number));
}

/// Adds a node and everything within it; returns its number. Groups are entered in a loop: their levels
/// take less of the stack than calls would.
std::uint32_t Preparer::add_root(ItemCursor items)
{
    std::array<Level, kfb::max_depth + 1> levels{};
    Level* level = levels.data();
    *level = {items, add_node({})};
    for (;;) {
        if (level->items.at_end()) {
            finish(level->node);
            if (level == levels.data())
                return level->node;
            --level;
            continue;
        }
        const ItemView item = level->items.next();
        const std::uint32_t number = add_item(item, level->node);
        if (item.kind == ItemKind::group)
            *++level = {ItemCursor{item.items}, number};
        else
            finish(number);
    }
}

/// Adds an item without what is within it; returns its number.
std::uint32_t Preparer::add_item(const ItemView& item, std::uint32_t around)
{
    Node node = node_of(item);
    if (add_tracks(item, node) && around < room_.nodes.size())
        room_.nodes[around].is_ordered = true;
    if (item.kind == ItemKind::object)
        add_keys(item.object);
    return add_node(node);
}

std::uint32_t Preparer::add_node(const Node& node)
{
    put_at(room_.nodes, records_.nodes, node);
    return records_.nodes++;
}

Node Preparer::node_of(const ItemView& item) const
{
    Node node{.place = scene_.place_of(item.place),
              .first_track = static_cast<std::uint16_t>(records_.tracks),
              .kind = item.kind,
              .live = item.live.kind,
              .deformer = item.object.deformer,
              .unit_bits = static_cast<std::uint8_t>(item.object.backbones.unit_bits),
              .has_arrivals = item.object.has_arrivals,
              .has_depths = item.object.has_depths,
              .is_placed = item.is_placed(),
              .has_path = item.path.is_known,
              .style = item.object.style};
    if (item.kind == ItemKind::use)
        node.of = symbol_node(item.symbol);
    if (item.kind == ItemKind::live)
        node.of = static_cast<std::uint16_t>(item.live.input);
    if (item.object.deformer == Deformer::bones) {
        node.of = static_cast<std::uint16_t>(scene_.first_bone(item.object.skeleton));
        node.bone_count = static_cast<std::uint8_t>(scene_.first_bone(item.object.skeleton + 1) - node.of);
    }
    return node;
}

/// The nodes of all symbols with lower numbers are before it.
std::uint16_t Preparer::symbol_node(std::uint32_t symbol) const
{
    std::uint16_t number = 0;
    for (; symbol > 0 && number < room_.nodes.size(); --symbol)
        number = room_.nodes[number].end;
    return number;
}

/// Returns whether it has an order.
bool Preparer::add_tracks(const ItemView& item, Node& node)
{
    bool has_order = false;
    for (TrackCursor tracks = item.tracks; !tracks.at_end(); ++node.track_count) {
        const TrackView track = tracks.next();
        has_order = has_order || track.property == Property::order;
        node.is_cut = node.is_cut || cuts_strokes(track.property);
        const auto property = static_cast<std::uint8_t>(track.property);
        if (track.is_fixed)
            add_track({.from = track.value, .to = track.value, .property = property});
        else
            add_track(property, track.keys.key_times(), track.keys.values(), track.is_smooth);
    }
    return has_order;
}

void Preparer::add_keys(const ObjectView& object)
{
    const auto add = [this](KeyValue value, const KeyTimeCursor& key_times, const PackedValues& values) {
        add_track(static_cast<std::uint8_t>(value), key_times, values);
    };
    const KeyCursor keys = object.keys();
    add(KeyValue::drawing, keys.key_times(), keys.drawings());
    if (object.has_arrivals)
        add(KeyValue::arrival, keys.key_times(), keys.arrivals());
    if (object.has_more())
        add(KeyValue::more, keys.key_times(), keys.more());
    if (object.deformer != Deformer::backbones)
        return;
    const BackboneKeyCursor backbones = object.backbones.keys();
    add(KeyValue::backbones, backbones.key_times(), backbones.drawings());
}

void Preparer::add_track(std::uint8_t property, const KeyTimeCursor& key_times, const PackedValues& values,
                         bool is_smooth)
{
    const std::uint16_t timeline = timeline_of(key_times, is_smooth);
    TrackState track{.values = scene_.place_of(values.place()),
                     .timeline = timeline,
                     .property = property,
                     .is_smooth = is_smooth};
    if (!track.has_timeline())
        track.from = track.to = values[0];
    add_track(track);
}

void Preparer::add_track(const TrackState& track) { put_at(room_.tracks, records_.tracks++, track); }

/// No timeline for a single key time.
std::uint16_t Preparer::timeline_of(const KeyTimeCursor& key_times, bool is_smooth)
{
    if (key_times.count() < 2)
        return TrackState::no_timeline;
    const std::uint32_t place = scene_.place_of(key_times.place());
    if (place != key_times_) {
        key_times_ = place;
        keys_ += key_times.count();
        timeline_ = static_cast<std::uint16_t>(records_.timelines);
        put_at(room_.timelines, records_.timelines++, KeyTimeline{place, key_times.driver()});
    }
    if (is_smooth && timeline_ < room_.timelines.size())
        room_.timelines[timeline_].move_with_time();
    return timeline_;
}

/// For a node after which everything within it is stored.
bool Preparer::has_several_layers(std::uint32_t number, const Node& node) const
{
    if (node.is_leaf())
        return node.style.is_filled && node.style.is_stroked;
    if (node.kind == ItemKind::use)
        return node.of < room_.nodes.size() && room_.nodes[node.of].has_several_layers;
    const std::uint32_t first = number + 1;
    if (first >= std::min<std::size_t>(node.end, room_.nodes.size()))
        return false;
    const Node& inside = room_.nodes[first];
    return inside.end != node.end || inside.has_several_layers;
}

void Preparer::finish(std::uint32_t number)
{
    if (number >= room_.nodes.size())
        return;
    Node& node = room_.nodes[number];
    node.end = static_cast<std::uint16_t>(records_.nodes);
    node.has_several_layers = has_several_layers(number, node);
}

}
