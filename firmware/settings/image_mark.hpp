#pragma once

#include "firmware/settings/board_settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kfast {

/// What a firmware image says about itself, so that it is not combined with settings that it cannot work
/// with. Stored; it is `place` bytes after the beginning of a .bin, and after it, put there by the linker, is
/// the size of the .bin in bytes: u32.
struct ImageMark {
    static constexpr std::size_t place = 0x1A8; ///< of the Pico: after boot block and vectors
    static constexpr std::size_t length_place = place + 8;
    static constexpr std::string_view its_magic = "KFPI";

    std::array<char, its_magic.size()> magic{'K', 'F', 'P', 'I'};
    BusKind bus; ///< the only one that the image can drive
    std::array<std::uint8_t, 3> unused{};

    constexpr explicit ImageMark(BusKind kind) : bus{kind} {}
};

static_assert(ImageMark::place + sizeof(ImageMark) == ImageMark::length_place);

}
