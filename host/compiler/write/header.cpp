#include "host/compiler/write/header.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/crc32.hpp"
#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/scene_view.hpp"

#include <algorithm>
#include <span>

namespace kfast {

namespace {

std::uint32_t rate_code(std::uint32_t rate)
{
    const bool is_whole = rate % 1000 == 0;
    return kfb::rate::in_1000_seconds.put(!is_whole) | kfb::rate::number.put(is_whole ? rate / 1000 : rate);
}

bool has_default_camera(const scene::Scene& scene) { return scene.camera == default_camera(scene.canvas); }

bool is_opaque(const Colour& colour) { return colour.opacity == 255; }

void write_colour(const Colour& colour, bool with_opacity, ByteWriter& bytes)
{
    for (const std::uint8_t part : {colour.red, colour.green, colour.blue})
        bytes.u8(part);
    if (with_opacity)
        bytes.u8(colour.opacity);
}

void write_palette(const std::vector<Colour>& palette, bool with_opacity, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(palette.size()));
    for (const Colour& colour : palette)
        write_colour(colour, with_opacity, bytes);
}

}

void write_header(const scene::Scene& scene, const Sections& sections, ByteWriter& bytes)
{
    constexpr OutlineNeeds nothing;
    const bool with_opacity = !std::ranges::all_of(scene.palette, is_opaque);
    bytes.varint(nothing.bytes);
    bytes.varint(nothing.borders);
    bytes.varint(nothing.cache_bytes);
    bytes.u8(kfb::header::loop.put(scene.loop) | kfb::header::has_camera.put(!has_default_camera(scene)) |
             kfb::header::has_opacity.put(with_opacity) | kfb::header::has_marks.put(sections.marks) |
             kfb::header::has_bones.put(sections.bones) | kfb::header::has_symbols.put(sections.symbols) |
             kfb::header::has_inputs.put(sections.inputs));
    bytes.varint(time_code(scene.length));
    bytes.varint(rate_code(scene.frame_rate));
    bytes.varint(static_cast<std::uint32_t>(scene.canvas.width));
    bytes.varint(static_cast<std::uint32_t>(scene.canvas.height));
    if (!has_default_camera(scene))
        bytes.varint(static_cast<std::uint32_t>(scene.camera));
    write_palette(scene.palette, with_opacity, bytes);
}

std::vector<std::byte> sealed(const ByteWriter& body)
{
    ByteWriter checked;
    checked.block(body.bytes());
    Crc32 crc;
    crc.add(checked.bytes());
    ByteWriter file;
    file.u32(kfb::tag::magic.put(kfb::tag::magic_value) | kfb::tag::version.put(kfb::version));
    file.u32(crc.value());
    file.append(checked.bytes());
    return file.bytes();
}

void set_outline_needs(std::vector<std::byte>& file, const OutlineNeeds& needs)
{
    ByteReader old{std::span{file}.subspan(kfb::header::checksum_end)};
    old.varint(); // the size
    for (int figure = 0; figure < 3; ++figure)
        old.varint();
    ByteWriter body;
    body.varint(needs.bytes / kfb::header::memory_unit);
    body.varint(needs.borders);
    body.varint(needs.cache_bytes / kfb::header::memory_unit);
    body.append(old.rest());
    file = sealed(body);
}

}
