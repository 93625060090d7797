#pragma once

#include "firmware/link/message_kind.hpp"
#include "firmware/report.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

/// The messages that bring a scene (message.hpp).
namespace kfast::link {

/// Bytes of the scene in a data report; only the last has fewer.
inline constexpr std::size_t block_bytes = payload_bytes - 2;
/// The numbers of blocks have 16 bits, including the one after the last.
inline constexpr std::uint32_t max_blocks = 0xFFFF;
constexpr std::uint32_t blocks_of(std::uint32_t bytes)
{
    constexpr std::uint32_t each{block_bytes};
    return bytes / each + (bytes % each != 0 ? 1 : 0);
}

/// A scene is going to come. Its tag is used by everything that belongs to the upload.
struct Begin {
    static constexpr Kind kind = Kind::begin;
    Home home = Home::slot; ///< slot or ram
    std::uint8_t slot = no_slot;
    std::uint32_t size = 0; ///< bytes
    std::uint32_t crc = 0;  ///< CRC-32 of all bytes (core/bytes/crc32.hpp)
    Name name{};

    static constexpr void fields(auto&& io, auto& it) { io(it.home, it.slot, it.size, it.crc, it.name); }
    friend constexpr bool operator==(const Begin&, const Begin&) = default;
};

struct Data {
    static constexpr Kind kind = Kind::data;
    std::uint16_t block = 0;
    std::array<std::byte, block_bytes> bytes{};

    static constexpr void fields(auto&& io, auto& it) { io(it.block, it.bytes); }
};

/// The progress of an upload: the answer to begin, and sent again and again while data come.
template <Kind which>
struct Progress {
    static constexpr Kind kind = which;
    static constexpr bool answers = true;
    std::uint16_t next = 0;   ///< the block that is wanted: all before it have come
    std::uint16_t window = 0; ///< how many blocks from there may be on the way
    bool is_missing = false;  ///< a later block has come: begin again from `next`

    static constexpr void fields(auto&& io, auto& it) { io(it.next, it.window, it.is_missing); }
    friend constexpr bool operator==(const Progress&, const Progress&) = default;
};
using Begun = Progress<Kind::begin>;
using Acknowledgement = Progress<Kind::data>;

using Commit = Plain<Kind::commit>;
using Cancel = Plain<Kind::cancel>;

}
