#include "core/scene/item_view.hpp"

#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"

#include <algorithm>

namespace kfast {
namespace {

bool is_known(std::uint32_t head, ItemKind kind)
{
    constexpr std::uint32_t style_bits =
        kfb::item::is_filled.mask() | kfb::item::is_stroked.mask() | kfb::item::is_even_odd.mask();
    constexpr std::uint32_t key_bits = kfb::item::has_arrivals.mask() | kfb::item::is_carried.mask();
    switch (kind) {
    case ItemKind::object:
        return true;
    case ItemKind::group:
    case ItemKind::use:
        return (head & (style_bits | key_bits)) == 0;
    case ItemKind::live:
        return (head & key_bits) == 0;
    }
    return false;
}

BeamStyle take_beam_style(ByteReader& bytes)
{
    BeamStyle style{.parts = static_cast<BeamParts>(bytes.u8())};
    if (!style.has_hatching())
        return style;
    style.spacing = static_cast<int>(std::min<std::uint32_t>(bytes.varint(), kfb::max_width + 1));
    style.direction = BinaryAngle::from_raw(static_cast<std::int32_t>(bytes.varint()));
    return style;
}

void take_tracks(ByteReader& bytes, ItemView& item)
{
    const std::uint32_t head = bytes.u8();
    item.tracks = TrackCursor{bytes, head & ~kfb::tracks::has_beam_style.mask()};
    item.is_known = item.is_known && head != 0;
    bool has_path = false;
    TrackCursor cursor = item.tracks;
    while (!cursor.at_end())
        has_path = cursor.next().property == Property::along || has_path;
    bytes = cursor.rest();
    if (kfb::tracks::has_beam_style.get(head)) {
        item.is_known = item.is_known && item.is_leaf();
        item.beam = take_beam_style(bytes);
    }
    if (!has_path)
        return;
    item.path = PathView::take(bytes);
    item.is_known = item.is_known && item.path.is_known;
}

void read_deformer(ByteReader& bytes, ObjectView& object)
{
    const std::uint32_t number = bytes.u8();
    object.deformer = number == kfb::item::by_backbones ? Deformer::backbones : Deformer::bones;
    if (number != kfb::item::by_backbones) {
        object.skeleton = number - 1;
    } else {
        object.backbones.unit_bits = bytes.u8();
        object.backbones.key_bytes = bytes;
        BackboneKeyCursor{bytes};
    }
}

void read_stroke_style(ByteReader& bytes, ObjectStyle& style)
{
    style.stroke = static_cast<std::uint8_t>(bytes.u8());
    style.width = static_cast<int>(std::min<std::uint32_t>(bytes.varint(), kfb::max_width + 1));
    const std::uint32_t ends = bytes.u8();
    style.cap = static_cast<Cap>(kfb::stroke::cap.get(ends));
    // The bits above are 0: parse() refuses all else.
    style.join = static_cast<Join>(kfb::stroke::join.get_with_above(ends));
    if (style.join == Join::miter)
        style.miter_limit = static_cast<std::uint8_t>(bytes.u8());
}

ObjectStyle take_style(ByteReader& bytes, std::uint32_t head)
{
    ObjectStyle style;
    style.is_filled = kfb::item::is_filled.get(head);
    style.is_stroked = kfb::item::is_stroked.get(head);
    style.fill_rule = kfb::item::is_even_odd.get(head) ? FillRule::even_odd : FillRule::nonzero;
    if (style.is_filled)
        style.fill = static_cast<std::uint8_t>(bytes.u8());
    if (style.is_stroked)
        read_stroke_style(bytes, style);
    return style;
}

ObjectView take_object(ByteReader& bytes, std::uint32_t head, bool has_depths)
{
    ObjectView object;
    object.has_depths = has_depths;
    object.style = take_style(bytes, head);
    object.has_arrivals = kfb::item::has_arrivals.get(head);
    if (kfb::item::is_carried.get(head))
        read_deformer(bytes, object);
    object.key_bytes = bytes;
    object.take_keys(bytes);
    return object;
}

/// After this, a wire frame is stored like an object.
void take_live_kind(ByteReader& bytes, ItemView& item)
{
    const std::uint32_t kind = bytes.u8();
    item.object.has_depths = kind == kfb::item::wire_frame;
    if (item.object.has_depths)
        item.kind = ItemKind::object;
    else
        item.live.kind = static_cast<InputLeaf>(kind);
}

/// Reads what follows the kind of a live item.
void take_live(ByteReader& bytes, std::uint32_t head, ItemView& item)
{
    switch (item.live.kind) {
    case InputLeaf::drawing:
        item.live.input = bytes.u8();
        item.object.style = take_style(bytes, head);
        return;
    case InputLeaf::label:
        item.live.input = bytes.u8();
        item.object.style = take_style(bytes, head);
        item.live.label = bytes.take(bytes.varint());
        return;
    }
    item.is_known = false;
}

}

KeyCursor::KeyCursor(ByteReader& bytes, bool has_arrivals, bool has_more)
    : key_times_{KeyTimeCursor::take(bytes, KeyTimeCursor::one())},
      drawings_{PackedValues::take(bytes, key_times_.count())},
      has_arrivals_{has_arrivals},
      has_more_{has_more}
{
    if (has_arrivals)
        arrivals_ = PackedValues::take(bytes, key_times_.count());
    if (has_more)
        more_ = PackedValues::take(bytes, key_times_.count());
}

Key KeyCursor::at(const KeyTime& key_time) const
{
    Key key{.time = key_time.time, .laws = key_time.laws};
    key.drawing = static_cast<std::uint32_t>(drawings_[key_time.index]);
    if (has_arrivals_)
        key.arrival = static_cast<std::uint32_t>(arrivals_[key_time.index]);
    if (has_more_)
        key.more = more_[key_time.index];
    return key;
}

/// The tracks that place it are the first ones.
bool ItemView::is_placed() const
{
    TrackCursor all = tracks;
    return !all.at_end() && places_item(all.next().property);
}

bool ItemView::is_cut() const
{
    for (TrackCursor all = tracks; !all.at_end();)
        if (cuts_strokes(all.next().property))
            return true;
    return false;
}

std::uint32_t ItemView::max_dashes() const
{
    bool is_dashed = false;
    std::int32_t max = default_max_dashes;
    for (TrackCursor all = tracks; !all.at_end();) {
        const TrackView track = all.next();
        is_dashed = is_dashed || is_dash_length(track.property);
        if (track.property == Property::max_dashes)
            max = track.value;
    }
    return is_dashed ? static_cast<std::uint32_t>(max) : 0;
}

ItemView ItemCursor::next()
{
    ItemView item;
    item.place = bytes_.rest().data();
    const std::uint32_t head = bytes_.u8();
    item.kind = static_cast<ItemKind>(kfb::item::kind.get(head));
    item.is_known = is_known(head, item.kind);
    if (item.kind == ItemKind::live)
        take_live_kind(bytes_, item);
    if (kfb::item::has_tracks.get(head))
        take_tracks(bytes_, item);
    switch (item.kind) {
    case ItemKind::object:
        item.object = take_object(bytes_, head, item.object.has_depths);
        break;
    case ItemKind::group:
        item.items = bytes_.take(bytes_.varint());
        break;
    case ItemKind::use:
        item.symbol = bytes_.u8();
        break;
    case ItemKind::live:
        take_live(bytes_, head, item);
        break;
    }
    return item;
}

}
