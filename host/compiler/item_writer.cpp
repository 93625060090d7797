#include "host/compiler/item_writer.hpp"

#include "core/item_view.hpp"
#include "host/compiler/backbone_writer.hpp"
#include "host/compiler/carrier.hpp"
#include "host/compiler/key_writer.hpp"
#include "host/compiler/path_writer.hpp"
#include "host/compiler/skinned_keys.hpp"
#include "host/compiler/track_writer.hpp"

namespace kfast {
namespace {

std::uint32_t flag(bool is_set, int bit) { return is_set ? 1U << bit : 0; }

std::uint32_t flags_of(const scene::Object& object)
{
    return flag(object.fill.has_value(), 3) | flag(object.stroke.has_value(), 4) |
           flag(object.fill && object.fill_rule == FillRule::even_odd, 5) | flag(has_arrivals(object), 6) |
           flag(carrier_of(object) != Carrier::none, 7);
}

std::uint32_t head_of(const scene::Item& item, bool has_tracks)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    const auto kind = static_cast<std::uint32_t>(
        object != nullptr && object->live ? ItemKind::live : static_cast<ItemKind>(item.content.index()));
    return kind | flag(has_tracks, 2) | (object != nullptr ? flags_of(*object) : 0);
}

void write_stroke_style(const scene::StrokeStyle& style, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(style.colour));
    bytes.varint(static_cast<std::uint32_t>(style.width));
    bytes.u8(static_cast<std::uint32_t>(style.cap) | static_cast<std::uint32_t>(style.join) << 2);
    if (style.join == Join::miter)
        bytes.u8(static_cast<std::uint32_t>(style.miter_limit));
}

void write_style(const scene::Object& object, ByteWriter& bytes)
{
    if (object.fill)
        bytes.u8(static_cast<std::uint32_t>(*object.fill));
    if (object.stroke)
        write_stroke_style(*object.stroke, bytes);
}

}

void ItemWriter::write(const std::vector<scene::Item>& items, ByteWriter& bytes)
{
    for (const scene::Item& item : items)
        write_item(item, bytes);
}

void ItemWriter::write_item(const scene::Item& item, ByteWriter& bytes)
{
    const std::vector<std::byte> tracks = packed_tracks(item, laws_);
    const auto* object = std::get_if<scene::Object>(&item.content);
    bytes.u8(head_of(item, !tracks.empty()));
    if (object != nullptr && object->live)
        bytes.u8(static_cast<std::uint32_t>(LiveKind::drawing));
    bytes.append(tracks);
    write_path(item, drawings_, bytes, diagnostics_);
    if (object != nullptr && object->live) {
        write_live(*object, bytes);
    } else if (object != nullptr) {
        write_object(*object, bytes);
    } else if (const auto* group = std::get_if<scene::Group>(&item.content)) {
        ByteWriter items;
        write(group->items, items);
        bytes.block(items.bytes());
    } else {
        bytes.u8(static_cast<std::uint32_t>(std::get<scene::Use>(item.content).symbol));
    }
}

void ItemWriter::write_carrier(const scene::Object& object, std::uint32_t unit_bits, ByteWriter& bytes)
{
    constexpr std::uint32_t backbones = 0;
    switch (carrier_of(object)) {
    case Carrier::none:
        return;
    case Carrier::backbones:
        bytes.u8(backbones);
        return write_backbones(object, unit_bits, laws_, drawings_, bytes);
    case Carrier::bones:
        return bytes.u8(static_cast<std::uint32_t>(object.skin->bones) + 1);
    }
}

void ItemWriter::write_live(const scene::Object& object, ByteWriter& bytes)
{
    points_[&object] = 0; // they are those of the input
    bytes.u8(static_cast<std::uint32_t>(*object.live));
    write_style(object, bytes);
}

void ItemWriter::write_object(const scene::Object& object, ByteWriter& bytes)
{
    const PackedKeys keys = object.skin ? packed_skinned_keys(object, laws_, drawings_, diagnostics_)
                                        : packed_keys(object, laws_, drawings_, diagnostics_);
    points_[&object] = keys.points + backbone_points(object);
    write_style(object, bytes);
    write_carrier(object, keys.unit_bits, bytes);
    bytes.append(keys.bytes);
}

}
