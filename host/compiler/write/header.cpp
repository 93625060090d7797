#include "host/compiler/write/header.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/crc32.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/scene_view.hpp"

#include <algorithm>
#include <span>

namespace kfast {

namespace {

constexpr std::size_t checked_at = 8; ///< what the checksum covers

std::uint32_t flag(bool is_set, int bit) { return is_set ? 1U << bit : 0; }

std::uint32_t rate_code(std::uint32_t rate) { return rate % 1000 == 0 ? rate / 1000 * 2 : rate * 2 + 1; }

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
    bytes.u8(static_cast<std::uint32_t>(scene.loop) | flag(!has_default_camera(scene), 2) |
             flag(with_opacity, 3) | flag(sections.marks, 4) | flag(sections.bones, 5) |
             flag(sections.symbols, 6) | flag(sections.inputs, 7));
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
    for (const char letter : {'K', 'F', 'B'})
        file.u8(static_cast<std::uint8_t>(letter));
    file.u8(kfb::version);
    file.u32(crc.value());
    file.append(checked.bytes());
    return file.bytes();
}

void set_outline_needs(std::vector<std::byte>& file, const OutlineNeeds& needs)
{
    ByteReader old{std::span{file}.subspan(checked_at)};
    old.varint(); // the size
    for (int figure = 0; figure < 3; ++figure)
        old.varint();
    ByteWriter body;
    body.varint(needs.bytes / 4);
    body.varint(needs.borders);
    body.varint(needs.cache_bytes / 4);
    body.append(old.rest());
    file = sealed(body);
}

}
