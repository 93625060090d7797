#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// CRC-16/IBM-3740, also called CRC-16/CCITT-FALSE: polynomial 0x1021, from 0xFFFF, not reflected. That of
/// the letters "123456789" is 0x29B1. For a few bytes now and then.
std::uint16_t crc16(std::span<const std::byte> bytes);

}
