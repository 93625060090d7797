#include "core/bytes/byte_reader.hpp"
#include "core/bytes/crc32.hpp"
#include "tests/fuzz/played.hpp"

#include <cstdint>
#include <vector>

namespace kfast {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t checked_at = 8; ///< what the checksum covers

void put(Bytes& bytes, std::size_t offset, std::uint32_t value)
{
    for (int shift = 0; shift < 32; shift += 8)
        bytes[offset++] = static_cast<std::byte>(value >> shift & 255);
}

/// The same bytes with a size and a checksum that fit, so that the fuzzer gets past them.
Bytes sealed(std::span<const std::byte> bytes)
{
    ByteReader reader{bytes.subspan(checked_at)};
    reader.varint(); // the size
    const std::span<const std::byte> body = reader.rest();
    Bytes copy(bytes.begin(), bytes.begin() + checked_at);
    std::size_t size = body.size();
    for (; size >= 0x80; size >>= 7)
        copy.push_back(static_cast<std::byte>(size | 0x80));
    copy.push_back(static_cast<std::byte>(size));
    copy.insert(copy.end(), body.begin(), body.end());
    Crc32 crc;
    crc.add(std::span{copy}.subspan(checked_at));
    put(copy, checked_at - 4, crc.value());
    return copy;
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto bytes = std::as_bytes(std::span{data, size});
    kfast::play(bytes);
    if (size >= kfast::checked_at)
        kfast::play(kfast::sealed(bytes));
    return 0;
}
