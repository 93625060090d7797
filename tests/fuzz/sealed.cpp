#include "tests/fuzz/sealed.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/crc32.hpp"
#include "core/scene/format.hpp"

#include <cstdint>

namespace kfast::test {

static_assert(sealed_from == kfb::header::checksum_end);

std::vector<std::byte> sealed(std::span<const std::byte> bytes)
{
    ByteReader reader{bytes.subspan(sealed_from)};
    reader.varint(); // the size
    const std::span<const std::byte> body = reader.rest();
    std::vector<std::byte> copy(bytes.begin(), bytes.begin() + sealed_from);
    std::size_t size = body.size();
    for (; size >= 0x80; size >>= 7)
        copy.push_back(static_cast<std::byte>(size | 0x80));
    copy.push_back(static_cast<std::byte>(size));
    copy.insert(copy.end(), body.begin(), body.end());
    Crc32 crc;
    crc.add(std::span{copy}.subspan(sealed_from));
    for (std::size_t i = 0; i < 4; ++i)
        copy[sealed_from - 4 + i] = static_cast<std::byte>(crc.value() >> 8 * i);
    return copy;
}

}
