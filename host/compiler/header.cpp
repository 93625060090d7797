#include "host/compiler/header.hpp"

#include "core/crc32.hpp"
#include "core/kfb_limits.hpp"

#include <algorithm>
#include <span>

namespace kfast {
namespace {

constexpr std::uint32_t sealing_bytes = 12; ///< what sealed() adds
constexpr std::size_t checksum_at = 4;
constexpr std::size_t checked_at = 8; ///< what the checksum covers
constexpr std::size_t outline_bytes_at = sealing_bytes;

void put(std::vector<std::byte>& file, std::size_t at, std::uint32_t value)
{
    ByteWriter bytes;
    bytes.u32(value);
    std::ranges::copy(bytes.bytes(), file.begin() + static_cast<std::ptrdiff_t>(at));
}

}

void write_header(const scene::Scene& scene, std::size_t law_pairs, ByteWriter& bytes)
{
    bytes.u32(0);
    bytes.u8(static_cast<std::uint32_t>(law_pairs));
    bytes.u8(static_cast<std::uint32_t>(scene.loop));
    bytes.u32(static_cast<std::uint32_t>(scene.length.ticks));
    bytes.u32(scene.frame_rate);
    bytes.u16(static_cast<std::uint32_t>(scene.canvas.width));
    bytes.u16(static_cast<std::uint32_t>(scene.canvas.height));
    bytes.u8(static_cast<std::uint32_t>(scene.palette.size()));
    bytes.u8(static_cast<std::uint32_t>(scene.symbols.size()));
    bytes.u16(static_cast<std::uint32_t>(scene.camera));
    for (const Colour colour : scene.palette)
        for (const std::uint8_t part : {colour.red, colour.green, colour.blue, colour.opacity})
            bytes.u8(part);
}

std::vector<std::byte> sealed(const ByteWriter& body)
{
    ByteWriter checked;
    checked.u32(static_cast<std::uint32_t>(body.size()) + sealing_bytes);
    checked.append(body.bytes());
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

void set_outline_bytes(std::vector<std::byte>& file, std::uint32_t outline_bytes)
{
    put(file, outline_bytes_at, outline_bytes);
    Crc32 crc;
    crc.add(std::span{file}.subspan(checked_at));
    put(file, checksum_at, crc.value());
}

}
