#include "core/scene_check.hpp"

#include "core/backbone_check.hpp"
#include "core/drawing_check.hpp"
#include "core/feature_code.hpp"
#include "core/key_moment.hpp"
#include "core/kfb_limits.hpp"
#include "core/live_backbones.hpp"

#include <algorithm>
#include <limits>

namespace kfast {
namespace {

/// How many bones the skeleton has that carries `object`; 0 if there is none.
std::uint32_t bones_of(const SceneView& scene, const ObjectView& object)
{
    if (object.carrier != Carrier::bones)
        return 0;
    BonesCursor skeletons = scene.skeletons();
    std::uint32_t bones = 0;
    for (std::uint32_t number = 0; number <= object.skeleton; ++number) {
        if (skeletons.at_end())
            return 0;
        bones = skeletons.skip();
    }
    return bones;
}

bool has_order(const ItemView& item)
{
    for (TrackCursor tracks = item.tracks; !tracks.at_end();)
        if (tracks.next().property == Property::order)
            return true;
    return false;
}

bool is_of_depth(Property property)
{
    return property == Property::z || property == Property::rotation_x || property == Property::rotation_y;
}

bool is_within(Fixed coordinate)
{
    return coordinate >= Fixed::sixteenths(std::numeric_limits<std::int16_t>::min()) &&
           coordinate <= Fixed::sixteenths(std::numeric_limits<std::int16_t>::max());
}

bool is_within(Point at) { return is_within(at.x) && is_within(at.y); }

/// Whether coordinates have 16 bits, as everything behind relies on.
bool is_within(const Segment& segment)
{
    return is_within(segment.to) && is_within(segment.c1) && is_within(segment.c2);
}

bool is_sound(const Binding& binding, std::uint32_t bones)
{
    bool sound = true;
    binding.each([&](BoneShare share) { sound = sound && share.bone < bones && share.weight >= 1; });
    return sound;
}

bool is_sound(const BeamStyle& beam, const ObjectStyle& style)
{
    if (beam.parts > BeamParts::both)
        return false;
    return !beam.has_hatching() ||
           (style.is_filled && beam.spacing >= kfb::min_hatch_spacing && beam.spacing <= kfb::max_width);
}

}

bool SceneCheck::passes()
{
    return check_header() && check_laws() && check_inputs() && check_clips() && check_events() &&
           check_bones() && check_symbols() && check_items(scene_.items(), scene_.symbol_count_, 0) &&
           count_items(scene_.items(), {}) && count_records();
}

/// Whether the program has it.
bool SceneCheck::needs(Feature feature)
{
    scene_.needed_features_.add(feature);
    if (scene_.features().has(feature))
        return true;
    error_ = error_without(feature);
    return false;
}

bool SceneCheck::check_header() const
{
    const auto is_side = [](int pixels) { return pixels >= 1 && pixels <= kfb::max_canvas; };
    return is_side(scene_.canvas_.width) && is_side(scene_.canvas_.height) &&
           scene_.camera_ >= kfb::min_camera && scene_.camera_ <= kfb::max_camera &&
           scene_.frame_rate_ >= 1 && scene_.frame_rate_ <= kfb::max_frame_rate &&
           scene_.length_.ticks >= Time::ticks_per_frame && scene_.length_.ticks <= kfb::max_time &&
           scene_.loop_ <= Loop::ping_pong && !scene_.palette_.empty() && scene_.colour(0).opacity == 255 &&
           scene_.outline_bytes_ <= kfb::max_outline_bytes && scene_.outline_bytes_ % 4 == 0 &&
           scene_.borders_ <= kfb::max_borders && scene_.cache_bytes_ <= kfb::max_cache_bytes;
}

bool SceneCheck::check_laws() const
{
    for (std::uint32_t number = 1; number <= scene_.law_count_; ++number) {
        const LawPair laws = scene_.laws(number);
        if (!is_valid(laws.x) || !is_valid(laws.y))
            return false;
    }
    return true;
}

bool SceneCheck::check_clips() const
{
    for (ClipCursor clips = scene_.clips(); !clips.at_end();) {
        const ClipView clip = clips.next();
        if (clip.name.empty() || clip.begin > scene_.length_ || clip.end <= clip.begin ||
            clip.end > scene_.length_ || clip.loop > Loop::ping_pong)
            return false;
        if (clips.rest().overrun())
            return false;
    }
    return true;
}

bool SceneCheck::check_events() const
{
    for (EventCursor events = scene_.events(); !events.at_end();) {
        const EventView event = events.next();
        if (event.name.empty() || event.time > scene_.length_ || events.overrun())
            return false;
    }
    return true;
}

bool SceneCheck::check_bones()
{
    if (scene_.skeletons().at_end())
        return true;
    if (!needs(Feature::bones) || !scene_.features().bones->check(scene_, scene_.law_count_))
        return false;
    std::uint32_t bones = 0;
    for (BonesCursor cursor = scene_.skeletons(); !cursor.at_end();)
        bones += cursor.skip();
    return bones <= kfb::max_bones_together;
}

bool SceneCheck::check_symbols()
{
    ByteReader symbols = scene_.symbols_;
    for (std::uint32_t number = 0; number < scene_.symbol_count_; ++number) {
        symbols.skip(symbols.varint());
        if (symbols.overrun() || !check_items(scene_.symbol(number), number, 1))
            return false;
    }
    return symbols.left() == 0;
}

bool SceneCheck::check_items(ItemCursor items, std::uint32_t usable_symbols, std::uint32_t depth)
{
    std::uint32_t count = 0;
    bool are_ordered = false;
    for (; !items.at_end(); ++count) {
        const ItemView item = items.next();
        if (items.overrun() || !check_item(item, usable_symbols, depth))
            return false;
        are_ordered = are_ordered || has_order(item);
    }
    return count <= kfb::max_ordered_items || !are_ordered;
}

bool SceneCheck::check_item(const ItemView& item, std::uint32_t usable_symbols, std::uint32_t depth)
{
    if (!item.is_known || !check_tracks(item) || !is_sound(item.beam, item.object.style))
        return false;
    if (item.path.is_known && (!needs(Feature::paths) || !scene_.features().paths->check(*this, item)))
        return false;
    switch (item.kind) {
    case ItemKind::object:
        return check_object(item.object);
    case ItemKind::group:
        return depth < kfb::max_depth && check_items(ItemCursor{item.items}, usable_symbols, depth + 1);
    case ItemKind::use:
        return item.symbol < usable_symbols;
    case ItemKind::live:
        return check_live(item);
    }
    return false;
}

bool SceneCheck::check_tracks(const ItemView& item)
{
    int before = -1;
    for (TrackCursor tracks = item.tracks; !tracks.at_end();) {
        const TrackView track = tracks.next();
        const int property = static_cast<int>(track.property);
        if (property <= before || property >= static_cast<int>(property_count) ||
            !check_track(track, item.object.style))
            return false;
        before = property;
    }
    return true;
}

bool SceneCheck::check_track(const TrackView& track, const ObjectStyle& style)
{
    if (is_of_depth(track.property) && !needs(Feature::depth))
        return false;
    if (track.is_smooth && !needs(Feature::smooth))
        return false;
    if (track.property == Property::fill && !style.is_filled)
        return false;
    if ((track.property == Property::stroke || track.property == Property::width) && !style.is_stroked)
        return false;
    if (track.is_smooth && (track.is_fixed || !may_be_smooth(track.property)))
        return false;
    if (track.is_fixed)
        return check_value(track, track.value);
    TrackKeyCursor keys = track.keys;
    if (keys.at_end())
        return false;
    for (Time before{-1}; !keys.at_end();) {
        const TrackKey key = keys.next();
        if (key.time <= before || !is_moment(keys.beats().clock(), key.time) || !is_law(key.laws) ||
            !check_value(track, key.value))
            return false;
        before = key.time;
    }
    return true;
}

bool SceneCheck::is_moment(Clock clock, Time time) const
{
    return is_key_moment(clock, time, scene_.number_inputs());
}

bool SceneCheck::check_value(const TrackView& track, std::int32_t value) const
{
    const ValueRange range = value_range(track.property);
    const bool is_colour = track.property == Property::fill || track.property == Property::stroke;
    return value >= range.least && value <= range.most &&
           (!is_colour || static_cast<std::size_t>(value) < scene_.palette_size());
}

bool SceneCheck::check_object(const ObjectView& object)
{
    const bool is_filled_wire = object.has_depths && object.style.is_filled;
    return !is_filled_wire && check_style(object.style) && check_carrier(object) && check_keys(object);
}

bool SceneCheck::check_style(const ObjectStyle& style)
{
    if (style.is_filled && style.fill >= scene_.palette_size())
        return false;
    if (!style.is_stroked)
        return style.is_filled;
    return needs(Feature::strokes) && style.stroke < scene_.palette_size() && style.width >= 1 &&
           style.width <= kfb::max_width && style.cap <= Cap::square && style.join <= Join::bevel &&
           style.miter_limit >= 8;
}

bool SceneCheck::check_keys(const ObjectView& object)
{
    KeyCursor keys = object.keys();
    if (keys.at_end())
        return false;
    const std::uint32_t bones = bones_of(scene_, object);
    const Key first = KeyCursor{keys}.next();
    if (object.has_arrivals && !needs(Feature::tweens))
        return false;
    for (Time before{-1}; !keys.at_end();) {
        const Key key = keys.next();
        if ((key.drawing != first.drawing || key.more != first.more) && !needs(Feature::tweens))
            return false;
        if (key.time <= before || !is_moment(keys.beats().clock(), key.time) || !is_law(key.laws) ||
            !check_drawing(key.drawing))
            return false;
        if (object.has_arrivals && !check_drawing(key.arrival))
            return false;
        if (object.carrier == Carrier::bones &&
            (!needs(Feature::bones) || !scene_.features().bones->check_skin(*this, key, bones)))
            return false;
        if (object.has_depths && (!needs(Feature::wires) || !scene_.features().wires->check(*this, key)))
            return false;
        before = key.time;
    }
    return true;
}

bool SceneCheck::check_drawing(std::uint32_t offset)
{
    if (offset >= scene_.drawings_.size())
        return false;
    PackedDrawing reader = scene_.drawing(offset);
    std::uint32_t points = reader.strokes();
    if (points > kfb::max_drawing_points)
        return false;
    for (std::uint32_t stroke = 0; stroke < reader.strokes(); ++stroke) {
        const std::uint32_t segments = reader.next_stroke();
        points += segments;
        if (!reader.is_sound() || !is_within(reader.start()) || segments > kfb::max_drawing_points ||
            points > kfb::max_drawing_points)
            return false;
        for (std::uint32_t i = 0; i < segments; ++i)
            if (!is_within(reader.next_segment()) || !reader.is_sound())
                return false;
    }
    key_points_ += points + 1;
    return reader.is_sound() && key_points_ <= kfb::max_key_points;
}

bool SceneCheck::check_path(const ItemView& item) const
{
    if (item.path.drawing >= scene_.drawings_.size())
        return false;
    PackedDrawing reader = scene_.drawing(item.path.drawing);
    const std::uint32_t segments = reader.strokes() == 1 ? reader.next_stroke() : 0;
    if (!reader.is_sound() || !is_within(reader.start()))
        return false;
    ByteReader lengths = item.path.lengths;
    std::uint32_t total = 0;
    for (std::uint32_t i = 0; i < segments; ++i) {
        const bool is_segment = is_within(reader.next_segment()) && reader.is_sound();
        const std::uint32_t length = lengths.varint();
        if (!is_segment || length == 0 || length > kfb::max_path || lengths.overrun())
            return false;
        total += length;
        if (total > kfb::max_path)
            return false;
    }
    return segments != 0 && lengths.left() == 0;
}

bool SceneCheck::check_carrier(const ObjectView& object)
{
    switch (object.carrier) {
    case Carrier::none:
        return true;
    case Carrier::backbones:
        return needs(Feature::backbones) && needs(Feature::tweens) &&
               scene_.features().backbones->check(*this, object.backbones);
    case Carrier::bones:
        return !object.has_arrivals && bones_of(scene_, object) != 0;
    }
    return false;
}

bool SceneCheck::check_backbones(const BackbonesView& backbones)
{
    BackboneKeyCursor keys = backbones.keys();
    if (keys.at_end() || backbones.unit_bits < 4 || backbones.unit_bits > 15)
        return false;
    const std::uint32_t first = backbones.keys().next().drawing;
    for (Time before{-1}; !keys.at_end();) {
        const BackboneKey key = keys.next();
        if (key.time <= before || !is_moment(keys.beats().clock(), key.time) || !is_law(key.laws) ||
            !check_drawing(key.drawing) || !are_backbones(scene_.drawing(key.drawing)) ||
            !is_built_alike(scene_.drawing(key.drawing), scene_.drawing(first)))
            return false;
        before = key.time;
    }
    scene_.backbone_nodes_ = std::max(scene_.backbone_nodes_, backbone_node_count(scene_.drawing(first)));
    return true;
}

bool SceneCheck::check_depths(const Key& key)
{
    const auto depths = static_cast<std::uint32_t>(key.more);
    return check_drawing(depths) && has_only_lines(scene_.drawing(key.drawing)) &&
           is_built_alike(scene_.drawing(key.drawing), scene_.drawing(depths));
}

bool SceneCheck::check_skin(const Key& key, std::uint32_t bones)
{
    if (key.more < 0)
        return static_cast<std::uint32_t>(-1 - key.more) < bones;
    if (static_cast<std::size_t>(key.more) >= scene_.drawings_.size())
        return false;
    SkinReader skin = scene_.skin(key.more);
    if (skin.has_drawing_at_rest() &&
        (!check_drawing(skin.drawing_at_rest()) ||
         !is_built_alike(scene_.drawing(key.drawing), scene_.drawing(skin.drawing_at_rest()))))
        return false;
    PackedDrawing drawing = scene_.drawing(key.drawing);
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke) {
        const std::uint32_t segments = drawing.next_stroke();
        for (std::uint32_t i = 0; i <= segments; ++i) {
            if (!is_sound(skin.next(), bones) || !skin.is_sound())
                return false;
            if (i != segments)
                drawing.next_segment();
        }
    }
    return skin.run_is_over() && skin.is_sound();
}

}
