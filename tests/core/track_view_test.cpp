#include "core/track_view.hpp"

#include "core/kfb_limits.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("tracks are read in their order, fixed ones and those with keys, and what follows is left")
{
    const auto tracks = bytes({0x85, 0x80, 0x80, 2,                    // rotation, a quarter turn
                               11, 8, 0, 1, 0xFE, 3, 0x81, 0x58, 2, 0, // opacity from 255 to 0
                               99});
    TrackCursor cursor{ByteReader{tracks}, 2};
    const TrackView rotation = cursor.next();
    CHECK(rotation.property == Property::rotation);
    CHECK(rotation.is_fixed);
    CHECK(rotation.value == 16384);
    CHECK_FALSE(cursor.at_end());
    const TrackView opacity = cursor.next();
    CHECK(cursor.at_end());
    CHECK(opacity.property == Property::opacity);
    CHECK_FALSE(opacity.is_fixed);
    CHECK_FALSE(opacity.is_smooth);
    TrackKeyCursor keys = opacity.keys;
    const TrackKey first = keys.next();
    CHECK(first.time == Time{});
    CHECK(first.laws == 1);
    CHECK(first.value == 255);
    const TrackKey second = keys.next();
    CHECK(second.time == Time{5632});
    CHECK(second.laws == 2);
    CHECK(second.value == 0);
    CHECK(keys.at_end());
    CHECK_FALSE(keys.overrun());
    CHECK(cursor.rest().left() == 1);
}

TEST_CASE("keys of a smooth track have no laws")
{
    const auto tracks = bytes({0x42, 5, 0, 0x80, 1, 4, 3, 0x80, 2}); // z; then a fixed x
    TrackCursor cursor{ByteReader{tracks}, 2};
    const TrackView z = cursor.next();
    CHECK(z.property == Property::z);
    CHECK(z.is_smooth);
    CHECK_FALSE(z.is_fixed);
    TrackKeyCursor keys = z.keys;
    const TrackKey first = keys.next();
    CHECK(first.time == Time{});
    CHECK(first.laws == 0);
    CHECK(first.value == 64);
    const TrackKey second = keys.next();
    CHECK(second.time == Time::frame(2));
    CHECK(second.value == -2);
    CHECK(keys.at_end());
    CHECK_FALSE(keys.overrun());
    CHECK_FALSE(cursor.next().is_smooth);
}

TEST_CASE("values are signed: even codes from 0 up, odd ones from -1 down")
{
    const auto value_of = [](std::initializer_list<int> code) {
        auto track = bytes(code);
        track.insert(track.begin(), std::byte{0x80});
        return TrackCursor{ByteReader{track}, 1}.next().value;
    };
    CHECK(value_of({0}) == 0);
    CHECK(value_of({1}) == -1);
    CHECK(value_of({2}) == 1);
    CHECK(value_of({0xFF, 0xFF, 0x7F}) == -1'048'576);
    CHECK(value_of({0x80, 0x80, 0x80, 0x01}) == 1'048'576);
    CHECK(value_of({0xFF, 0xFF, 0xFF, 0xFF, 0x0F}) == -2147483647 - 1);
}

TEST_CASE("times of keys add up")
{
    const auto track = bytes({0, 9, 4, 0, 0, 3, 0, 0, 2, 0, 0});
    TrackKeyCursor keys = TrackCursor{ByteReader{track}, 1}.next().keys;
    CHECK(keys.next().time == Time::frame(2));
    CHECK(keys.next().time == Time{2 * 1024 + 1});
    CHECK(keys.next().time == Time{3 * 1024 + 1});
    CHECK(keys.at_end());
}

TEST_CASE("tracks and keys that break off are noticed")
{
    const auto key = bytes({0, 2, 4, 0});
    TrackKeyCursor keys = TrackCursor{ByteReader{key}, 1}.next().keys;
    keys.next();
    CHECK(keys.overrun());

    const auto track = bytes({0, 9, 4, 0});
    TrackCursor cut{ByteReader{track}, 1};
    cut.next();
    CHECK(cut.rest().overrun());

    const auto value = bytes({0x80, 0x80});
    TrackCursor fixed{ByteReader{value}, 1};
    fixed.next();
    CHECK(fixed.rest().overrun());
}

TEST_CASE("without tracks there is nothing to read") { CHECK(TrackCursor{}.at_end()); }

}
