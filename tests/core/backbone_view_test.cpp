#include "core/backbone_view.hpp"

#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("keys of backbones count their times from the key before")
{
    const auto keys = bytes({4, 2, 0x81, 1, 3, 0, 7});
    BackboneKeyCursor cursor = BackbonesView{.unit_bits = 4, .key_bytes = ByteReader{keys}}.keys();
    const BackboneKey first = cursor.next();
    CHECK(first.time == Time::frame(2));
    CHECK(first.laws == 2);
    CHECK(first.drawing == 129);
    const BackboneKey second = cursor.next();
    CHECK(second.time == Time{2 * 1024 + 1});
    CHECK(second.drawing == 7);
    CHECK(cursor.at_end());
    CHECK_FALSE(cursor.overrun());
}

TEST_CASE("a key of backbones that breaks off is noticed")
{
    const auto key = bytes({4, 2, 0x81});
    BackboneKeyCursor cursor{ByteReader{key}};
    cursor.next();
    CHECK(cursor.overrun());
}

}
