#include "host/compiler/item_writer.hpp"

#include "core/edge_budget.hpp"
#include "host/compiler/backbone_writer.hpp"
#include "host/compiler/carrier.hpp"
#include "host/compiler/key_writer.hpp"
#include "host/compiler/object_style.hpp"
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
    const auto kind = static_cast<std::uint32_t>(item.content.index());
    const auto* object = std::get_if<scene::Object>(&item.content);
    return kind | flag(has_tracks, 2) | (object != nullptr ? flags_of(*object) : 0);
}

void write_stroke_style(const ObjectStyle& style, ByteWriter& bytes)
{
    bytes.u8(style.stroke);
    bytes.varint(static_cast<std::uint32_t>(style.width));
    bytes.u8(static_cast<std::uint32_t>(style.cap) | static_cast<std::uint32_t>(style.join) << 2);
    if (style.join == Join::miter)
        bytes.u8(static_cast<std::uint32_t>(style.miter_limit));
    bytes.varint(style.arc_pieces);
}

}

void ItemWriter::write(const std::vector<scene::Item>& items, const Enlargement& around, ByteWriter& bytes)
{
    for (const scene::Item& item : items)
        write_item(item, around, bytes);
}

void ItemWriter::write_item(const scene::Item& item, const Enlargement& around, ByteWriter& bytes)
{
    const std::vector<std::byte> tracks = packed_tracks(item, laws_);
    bytes.u8(head_of(item, !tracks.empty()));
    bytes.append(tracks);
    write_path(item, drawings_, bytes, diagnostics_);
    const Enlargement inside = around.inside(item);
    if (const auto* object = std::get_if<scene::Object>(&item.content)) {
        const double scale = inside.factor();
        write_object(*object, object_style(*object, item.tracks, scale), scale, bytes);
    } else if (const auto* group = std::get_if<scene::Group>(&item.content)) {
        ByteWriter items;
        write(group->items, inside, items);
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

void ItemWriter::write_object(const scene::Object& object, const ObjectStyle& style, double scale,
                              ByteWriter& bytes)
{
    const PackedKeys keys = object.skin
                                ? packed_skinned_keys(object, scene_, scale, laws_, drawings_, diagnostics_)
                                : packed_keys(object, scale, laws_, drawings_, diagnostics_);
    const std::uint64_t edges = object_edges({.style = style,
                                              .carrier = carrier_of(object),
                                              .has_arrivals = has_arrivals(object),
                                              .key_bytes = ByteReader{keys.bytes}},
                                             drawings_.bytes());
    needs_[&object] = {edges, keys.points + backbone_points(object)};
    if (style.is_filled)
        bytes.u8(style.fill);
    if (style.is_stroked)
        write_stroke_style(style, bytes);
    write_carrier(object, keys.unit_bits, bytes);
    bytes.varint(static_cast<std::uint32_t>(edges));
    bytes.block(keys.bytes);
}

}
