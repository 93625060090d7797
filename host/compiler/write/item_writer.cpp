#include "host/compiler/write/item_writer.hpp"

#include "core/scene/item_view.hpp"
#include "host/compiler/carry/deformer.hpp"
#include "host/compiler/write/backbone_writer.hpp"
#include "host/compiler/write/key_writer.hpp"
#include "host/compiler/write/label_writer.hpp"
#include "host/compiler/write/path_writer.hpp"
#include "host/compiler/write/skinned_keys.hpp"
#include "host/compiler/write/track_writer.hpp"

#include <cstddef>
#include <optional>

namespace kfast {
namespace {

std::uint32_t flag(bool is_set, int bit) { return is_set ? 1U << bit : 0; }

/// What of an item comes from outside.
struct Live {
    InputLeaf kind;
    std::size_t input; ///< index into Scene::inputs
};

std::optional<Live> live_of(const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    if (object != nullptr && object->live)
        return Live{InputLeaf::drawing, *object->live};
    if (object != nullptr && object->label)
        return Live{InputLeaf::label, object->label->input};
    return std::nullopt;
}

/// What stands behind the head of a live item, or of a wire frame, which is stored as one.
std::optional<std::uint32_t> kind_of_live(const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    if (object != nullptr && object->has_depths)
        return wire_kind;
    const auto live = live_of(item);
    return live ? std::optional{static_cast<std::uint32_t>(live->kind)} : std::nullopt;
}

std::uint32_t style_flags_of(const scene::Object& object)
{
    return flag(object.fill.has_value(), 3) | flag(object.stroke.has_value(), 4) |
           flag(object.fill && object.fill_rule == FillRule::even_odd, 5);
}

std::uint32_t key_flags_of(const scene::Object& object)
{
    return flag(has_arrivals(object), 6) | flag(deformer_of(object) != Deformer::none, 7);
}

std::uint32_t head_of(const scene::Item& item, bool has_tracks)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    const bool has_kind = kind_of_live(item).has_value();
    const auto kind = has_kind ? ItemKind::live : static_cast<ItemKind>(item.content.index());
    return static_cast<std::uint32_t>(kind) | flag(has_tracks, 2) |
           (object != nullptr ? style_flags_of(*object) : 0) |
           (object != nullptr && !has_kind ? key_flags_of(*object) : 0);
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
    if (const auto kind = kind_of_live(item))
        bytes.u8(*kind);
    bytes.append(tracks);
    write_path(item, drawings_, bytes, diagnostics_);
    if (const auto live = live_of(item)) {
        bytes.u8(static_cast<std::uint32_t>(live->input));
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

void ItemWriter::write_deformer(const scene::Object& object, std::uint32_t unit_bits, ByteWriter& bytes)
{
    constexpr std::uint32_t backbones = 0;
    switch (deformer_of(object)) {
    case Deformer::none:
        return;
    case Deformer::backbones:
        bytes.u8(backbones);
        return write_backbones(object, unit_bits, laws_, drawings_, bytes);
    case Deformer::bones:
        return bytes.u8(static_cast<std::uint32_t>(object.skin->bones) + 1);
    }
}

/// Behind the number of the input.
void ItemWriter::write_live(const scene::Object& object, ByteWriter& bytes)
{
    write_style(object, bytes);
    if (!object.label)
        return;
    ByteWriter label;
    write_label(*object.label, drawings_, label);
    bytes.block(label.bytes());
}

void ItemWriter::write_object(const scene::Object& object, ByteWriter& bytes)
{
    const PackedKeys keys = object.skin ? packed_skinned_keys(object, laws_, drawings_, diagnostics_)
                                        : packed_keys(object, laws_, drawings_, diagnostics_);
    write_style(object, bytes);
    write_deformer(object, keys.unit_bits, bytes);
    bytes.append(keys.bytes);
}

}
