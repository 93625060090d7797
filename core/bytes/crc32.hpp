#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// CRC-32 as in zlib, PNG and Ethernet (polynomial 0xEDB88320, reflected), byte by byte.
class Crc32 {
public:
    void add(std::span<const std::byte> bytes);
    std::uint32_t value() const { return ~state_; }

private:
    std::uint32_t state_ = 0xFFFFFFFF;
};

}
