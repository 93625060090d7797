#include "core/scene/skeleton_view.hpp"

#include "tests/core/raw_scene.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("keys of backbones have times, laws and drawings")
{
    const Bytes keys = key_bytes({{Time::frame(2), 2, 129}, {Time{2 * 1024 + 1}, 0, 7}});
    BackboneKeyCursor cursor = BackbonesView{.unit_bits = 4, .key_bytes = ByteReader{keys}}.keys();
    const BackboneKey first = cursor.next();
    CHECK(first.time == Time::frame(2));
    CHECK(first.laws == 2);
    CHECK(first.drawing == 129);
    const BackboneKey second = cursor.next();
    CHECK(second.time == Time{2 * 1024 + 1});
    CHECK(second.drawing == 7);
    CHECK(cursor.at_end());
}

TEST_CASE("backbones that stay have one key at 0")
{
    const Bytes key = bytes({0, 0x82, 2, 99});
    ByteReader bytes{key};
    BackboneKeyCursor cursor{bytes};
    const BackboneKey only = cursor.next();
    CHECK(only.time == Time{});
    CHECK(only.drawing == 129);
    CHECK(cursor.at_end());
    CHECK(bytes.left() == 1);
}

TEST_CASE("keys of backbones that break off are noticed")
{
    const Bytes keys = key_bytes({{Time::frame(2), 2, 129}, {Time{2 * 1024 + 1}, 0, 7}});
    for (std::size_t size = 0; size < keys.size(); ++size) {
        ByteReader cut{std::span{keys}.first(size)};
        BackboneKeyCursor{cut};
        CHECK(cut.overrun());
    }
}

}
