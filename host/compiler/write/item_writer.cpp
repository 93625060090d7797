#include "host/compiler/write/item_writer.hpp"

#include "core/scene/format.hpp"
#include "core/scene/item_view.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/compiler/carry/deformed_tweens.hpp"
#include "host/compiler/match/measured_stroke.hpp"
#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/compiler/pack/value_writer.hpp"
#include "host/compiler/write/key_writer.hpp"
#include "host/compiler/write/track_writer.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

namespace {

void write_glyphs(const std::vector<std::uint8_t>& glyphs, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(glyphs.size()));
    for (const std::uint8_t glyph : glyphs)
        bytes.u8(glyph);
}

void write_format(const scene::NumberFormat& format, ByteWriter& bytes)
{
    bytes.u8(format.decimals);
    bytes.u8(kfb::number_format::digits.put(format.digits) | kfb::number_format::places.put(format.places));
    write_glyphs(format.before, bytes);
    write_glyphs(format.behind, bytes);
}

/// Appends a label (docs/format.md, "Live items"), whose drawings go to `drawings`.
void write_label(const scene::Label& label, DrawingPool& drawings, ByteWriter& bytes)
{
    bytes.u8(kfb::label::align.put(label.align) | kfb::label::shows_number.put(label.format.has_value()));
    for (const std::int32_t value : {std::int32_t{label.at.x}, std::int32_t{label.at.y}, label.spacing})
        bytes.signed_varint(value);
    std::vector<std::int32_t> offsets;
    std::vector<std::int32_t> advances;
    for (const scene::LabelGlyph& glyph : label.glyphs) {
        offsets.push_back(drawings.offset_of(glyph.drawing));
        advances.push_back(glyph.advance);
    }
    bytes.u8(static_cast<std::uint32_t>(label.glyphs.size()));
    write_values(offsets, bytes);
    write_values(advances, bytes);
    std::vector<std::int32_t> kerning;
    bytes.u16(static_cast<std::uint32_t>(label.kerning.size()));
    for (const scene::Kerning& pair : label.kerning) {
        bytes.u16(kfb::kerning::left.put(pair.left) | kfb::kerning::right.put(pair.right));
        kerning.push_back(pair.by);
    }
    if (!kerning.empty())
        write_values(kerning, bytes);
    if (label.format)
        write_format(*label.format, bytes);
}

std::uint32_t stored_length(const MeasuredSegment& segment)
{
    return static_cast<std::uint32_t>(std::max(std::lround(segment.length * 16), 1L));
}

void report_length(const scene::Item& item, Diagnostics& diagnostics)
{
    diagnostics.error(item.place, "the path of this item is too long for the format",
                      "at most " + std::to_string(kfb::max_path / 16) +
                          " px; draw it shorter or with fewer turns");
}

/// Appends the path that `item` follows, if it has one (docs/format.md, "Tracks"), its curves divided so that
/// the core can go along it evenly. One that is too long for the format is an error.
void write_path(const scene::Item& item, DrawingPool& drawings, ByteWriter& bytes, Diagnostics& diagnostics)
{
    if (!item.path)
        return;
    const MeasuredStroke drawn = measured(item.path->stroke);
    // To make it even might take long.
    if (length_of(drawn) > kfb::max_path / 16.0)
        return report_length(item, diagnostics);
    const scene::Drawing drawing{{rounded(made_even(drawn))}};
    ByteWriter path;
    path.u8(item.path->turns ? 1 : 0);
    path.varint(static_cast<std::uint32_t>(drawings.offset_of(drawing)));
    std::uint64_t whole = 0;
    for (const MeasuredSegment& segment : measured(drawing.strokes.front())) {
        const std::uint32_t length = stored_length(segment);
        path.varint(length);
        whole += length;
    }
    bytes.block(path.bytes());
    if (whole > kfb::max_path || point_count(drawing) > kfb::max_drawing_points)
        report_length(item, diagnostics);
}

/// What an item shows that comes from outside.
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

/// What follows the head of a live item, or of a wire frame, which is stored as one.
std::optional<std::uint32_t> kind_of_live(const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    if (object != nullptr && object->has_depths)
        return kfb::item::wire_frame;
    const auto live = live_of(item);
    return live ? std::optional{static_cast<std::uint32_t>(live->kind)} : std::nullopt;
}

std::uint32_t style_flags_of(const scene::Object& object)
{
    return kfb::item::is_filled.put(object.fill.has_value()) |
           kfb::item::is_stroked.put(object.stroke.has_value()) |
           kfb::item::is_even_odd.put(object.fill && object.fill_rule == FillRule::even_odd);
}

std::uint32_t key_flags_of(const scene::Object& object)
{
    return kfb::item::has_arrivals.put(has_arrivals(object)) |
           kfb::item::is_carried.put(deformer_of(object) != Deformer::none);
}

std::uint32_t head_of(const scene::Item& item, bool has_tracks)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    const bool has_kind = kind_of_live(item).has_value();
    const auto kind = has_kind ? ItemKind::live : static_cast<ItemKind>(item.content.index());
    return kfb::item::kind.put(kind) | kfb::item::has_tracks.put(has_tracks) |
           (object != nullptr ? style_flags_of(*object) : 0) |
           (object != nullptr && !has_kind ? key_flags_of(*object) : 0);
}

void write_stroke_style(const scene::StrokeStyle& style, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(style.colour));
    bytes.varint(static_cast<std::uint32_t>(style.width));
    bytes.u8(kfb::stroke::cap.put(style.cap) | kfb::stroke::join.put(style.join));
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
    switch (deformer_of(object)) {
    case Deformer::none:
        return;
    case Deformer::backbones:
        bytes.u8(kfb::item::by_backbones);
        return write_backbones(object, unit_bits, laws_, drawings_, bytes);
    case Deformer::bones:
        return bytes.u8(static_cast<std::uint32_t>(object.skin->bones) + 1);
    }
}

/// Writes what follows the number of the input.
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
