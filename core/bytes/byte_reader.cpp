#include "core/bytes/byte_reader.hpp"

namespace kfast {

BitReader BitReader::take(ByteReader& bytes, std::uint32_t count, std::uint32_t width)
{
    constexpr std::uint32_t max_numbers = 1U << 25; // so that their bits can be counted
    const BitReader bits{bytes.rest()};
    const std::size_t size = (count * width + 7) / 8;
    bytes.skip(count < max_numbers ? std::min(size, bytes.left() + 1) : bytes.left() + 1);
    return bits;
}

/// Of the end of the bytes, or from after it.
std::uint32_t BitReader::last_word(std::uint32_t byte) const
{
    std::uint32_t word = 0;
    for (int shift = 24; shift >= 0 && byte < size_; shift -= 8)
        word |= std::to_integer<std::uint32_t>(bytes_[byte++]) << shift;
    return word;
}

}
