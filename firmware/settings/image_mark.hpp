#pragma once

#include "firmware/settings/board_settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kfast {

/// What a firmware image tells about itself, so that it need not meet settings that it cannot work with.
/// Stored; it lies `place` bytes after the beginning of a .bin, and behind it, put there by the linker, how
/// many bytes the .bin has: u32.
struct ImageMark {
    static constexpr std::size_t place = 0x1A8; ///< of the Pico: behind boot block and vectors
    static constexpr std::size_t length_place = place + 8;
    static constexpr std::string_view its_magic = "KFPI";

    std::array<char, its_magic.size()> magic{'K', 'F', 'P', 'I'};
    BusKind bus; ///< the only one that the image can drive
    std::array<std::uint8_t, 3> unused{};

    constexpr explicit ImageMark(BusKind kind) : bus{kind} {}
};

static_assert(ImageMark::place + sizeof(ImageMark) == ImageMark::length_place);

}
