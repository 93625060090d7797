#include "core/bytes/byte_reader.hpp"

#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("numbers are little-endian, and beyond the end they are zero")
{
    const auto data = bytes({0x01, 0x34, 0x12, 0x78, 0x56, 0x34, 0x12, 0xFF});
    ByteReader reader{data};
    CHECK(reader.u8() == 1);
    CHECK(reader.u16() == 0x1234);
    CHECK(reader.u32() == 0x12345678);
    CHECK(!reader.overrun());
    CHECK(reader.u16() == 0xFF);
    CHECK(reader.overrun());
}

TEST_CASE("a varint has up to 32 bits")
{
    const auto data = bytes({0x7F, 0x80, 0x01, 0xFF, 0xFF, 0xFF, 0xFF, 0x0F});
    ByteReader reader{data};
    CHECK(reader.varint() == 127);
    CHECK(reader.varint() == 128);
    CHECK(reader.varint() == 0xFFFFFFFF);
    CHECK(!reader.overrun());
}

TEST_CASE("a varint of more than 32 bits, or without an end, is refused")
{
    for (const auto& data : {bytes({0x80, 0x80, 0x80, 0x80, 0x10}),
                             bytes({0xFF, 0xFF, 0xFF, 0xFF, 0x8F, 0x01}), bytes({0x80, 0x80})}) {
        ByteReader reader{data};
        CHECK(reader.varint() == 0);
        CHECK(reader.overrun());
    }
}

TEST_CASE("skipping ends at the end")
{
    const auto data = bytes({1, 2, 3});
    ByteReader reader{data};
    reader.skip(2);
    CHECK(reader.left() == 1);
    CHECK(!reader.overrun());
    reader.skip(2);
    CHECK(reader.left() == 0);
    CHECK(reader.overrun());
}

}
