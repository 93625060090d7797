#include "core/features.hpp"
#include "core/scene/check/scene_check.hpp"
#include "core/scene/kfb_limits.hpp"

#include <array>

/// Items, their tracks, and what they cost.
namespace kfast {
namespace {

bool is_of_depth(Property property)
{
    return property == Property::z || property == Property::rotation_x || property == Property::rotation_y;
}

bool is_valid(const BeamStyle& beam, const ObjectStyle& style)
{
    if (beam.parts > BeamParts::both)
        return false;
    return !beam.has_hatching() ||
           (style.is_filled && beam.spacing >= kfb::min_hatch_spacing && beam.spacing <= kfb::max_width);
}

/// The instructions of what deforms the points of an object, or lays them out.
std::uint32_t instructions_per_point(const ItemView& item)
{
    constexpr std::uint32_t seen_in_perspective = 1024;
    constexpr std::uint32_t bent = 768;
    constexpr std::uint32_t deformed = 256;
    if (item.object.has_depths)
        return seen_in_perspective;
    if (item.object.deformer == Deformer::backbones)
        return bent;
    return item.object.deformer == Deformer::bones ? deformed : 0;
}

}

/// `depth` is that of what is around them. Groups are entered in a loop: their levels take less of the
/// stack than calls would.
bool SceneCheck::check_items(ItemCursor items, std::uint32_t usable_symbols, std::uint32_t depth,
                             ItemTotals& totals)
{
    std::array<Level, kfb::max_depth + 1> levels{};
    Level* level = levels.data();
    const Level* const deepest = level + (kfb::max_depth - depth);
    level->items = items;
    for (;;) {
        if (level->items.at_end()) {
            if (!end_list(*level))
                return false;
            if (level == levels.data())
                break;
            const ItemTotals own = level->totals.in_item();
            const Tracks tracks = level->tracks;
            (--level)->add(own, tracks);
            continue;
        }
        const ItemView item = level->items.next();
        ++items_read_;
        ++level->count;
        Tracks tracks;
        if (level->items.overrun() || !check_tracks(item, tracks) || !check_item(item, *level, tracks))
            return false;
        if (item.kind == ItemKind::group) {
            if (level == deepest)
                return false;
            *++level = {.items = ItemCursor{item.items}, .tracks = tracks};
        } else {
            ItemTotals own;
            if (!check_content(item, tracks.seen, usable_symbols, own))
                return false;
            level->add(own, tracks);
        }
    }
    totals = level->totals;
    return true;
}

/// Checks what all kinds of items have. From here on `tracks` also include when its surroundings are visible.
bool SceneCheck::check_item(const ItemView& item, Level& level, Tracks& tracks)
{
    const std::uint32_t cost = cost_of_item(tracks.count);
    cost_.add(cost, level.tracks.seen);
    shown_ |= cost > 1 ? level.tracks.seen : 0;
    level.ordered = static_cast<std::uint16_t>(level.ordered + (tracks.has_order ? 1 : 0));
    tracks.is_placed = item.is_placed();
    tracks.seen &= level.tracks.seen;
    if (!item.is_known || !is_valid(item.beam, item.object.style))
        return false;
    if (!item.path.is_known)
        return true;
    if (!needs(Feature::paths) || !scene_.features().paths->check(*this, item))
        return false;
    add_cost(cost_of_path(points_), tracks.seen);
    return true;
}

/// Checks all kinds except groups. `seen`: in which parts of the scene.
bool SceneCheck::check_content(const ItemView& item, std::uint32_t seen, std::uint32_t usable_symbols,
                               ItemTotals& own)
{
    if (item.is_leaf()) {
        own = ItemTotals::of_leaf(item.object.style);
        return check_leaf(item, seen);
    }
    if (item.symbol >= usable_symbols)
        return false;
    own = symbols_[item.symbol].in_item();
    cost_.add(own.items, seen & ~own.shown);
    add_cost(own.cost, seen & own.shown);
    return true;
}

/// Ends a list of items.
bool SceneCheck::end_list(const Level& level)
{
    if (level.ordered == 0)
        return true;
    cost_.add(cost_of_ordered(level.count, level.ordered), level.tracks.seen);
    shown_ |= level.tracks.seen;
    return level.count <= kfb::max_ordered_items;
}

void SceneCheck::Level::add(ItemTotals item, const Tracks& of_item)
{
    if (of_item.may_be_transparent && item.has_several_layers)
        item.blend();
    if (of_item.is_placed)
        item.place();
    totals.add(item);
}

bool SceneCheck::check_leaf(const ItemView& item, std::uint32_t seen)
{
    points_ = strokes_ = 0;
    if (!(item.kind == ItemKind::object ? check_object(item.object) : check_live(item)))
        return false;
    add_cost(cost_of_leaf(item.object.style, points_, instructions_per_point(item)), seen);
    if (item.is_cut())
        add_cost(cost_of_trim(item.object.style, points_, strokes_) + cost_of_dashes(item.max_dashes()),
                 seen);
    return true;
}

/// Adds a cost of the current item.
void SceneCheck::add_cost(std::uint32_t cost, std::uint32_t seen)
{
    cost_.add(cost, seen);
    shown_ |= seen;
    if (cost > max_ && seen != 0) {
        max_ = cost;
        item_ = items_read_ - 1;
    }
}

bool SceneCheck::check_tracks(const ItemView& item, Tracks& tracks)
{
    int before = -1;
    for (TrackCursor cursor = item.tracks; !cursor.at_end(); ++tracks.count) {
        const TrackView track = cursor.next();
        const int property = static_cast<int>(track.property);
        if (property <= before || property >= static_cast<int>(property_count) ||
            !check_track(track, item.object.style) ||
            (cuts_strokes(track.property) && !check_cut(item, track)))
            return false;
        before = property;
        tracks.has_order = tracks.has_order || track.property == Property::order;
        if (track.property == Property::opacity)
            tracks.may_be_transparent = !track.is_fixed || track.value != 255;
        if (track.property == Property::opacity || track.property == Property::visible)
            tracks.seen &= seen_by(track);
    }
    return true;
}

/// In which parts of the scene an item with this opacity or visibility may be visible.
std::uint32_t SceneCheck::seen_by(const TrackView& track) const
{
    if (track.is_fixed)
        return track.value == 0 ? 0 : SceneParts::all;
    TrackKeyCursor keys = track.keys;
    if (track.is_smooth || !keys.key_times().driver().is_time())
        return SceneParts::all;
    TrackKey from = keys.next();
    std::uint32_t seen = from.value != 0 ? parts_.between({}, from.time) : 0;
    while (!keys.at_end()) {
        const TrackKey to = keys.next();
        const bool is_held = track.property == Property::visible || is_hold(from.laws);
        if (from.value != 0 || (to.value != 0 && !is_held))
            seen |= parts_.between(from.time, to.time);
        from = to;
    }
    return from.value != 0 ? seen | parts_.between(from.time, scene_.length() + Time{1}) : seen;
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
    if (keys.at_end() || !may_read(keys.key_times().count()))
        return false;
    for (Time before{-1}; !keys.at_end();) {
        const TrackKey key = keys.next();
        if (key.time <= before || !is_moment(keys.key_times().driver(), key.time) || !is_law(key.laws) ||
            !check_value(track, key.value))
            return false;
        before = key.time;
    }
    return true;
}

bool SceneCheck::check_cut(const ItemView& item, const TrackView& track)
{
    const bool is_mode = track.property == Property::trim_mode || track.property == Property::max_dashes;
    return needs(Feature::trims) && item.is_leaf() && !item.object.has_depths &&
           (!is_of_dashes(track.property) || item.object.style.is_stroked) && (!is_mode || track.is_fixed);
}

bool SceneCheck::check_value(const TrackView& track, std::int32_t value) const
{
    const ValueRange range = value_range(track.property);
    const bool is_colour = track.property == Property::fill || track.property == Property::stroke;
    return value >= range.min && value <= range.max &&
           (!is_colour || static_cast<std::size_t>(value) < scene_.palette_size());
}

}
