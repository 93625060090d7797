#include "core/scene/track_view.hpp"

#include "tests/core/raw_scene.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("tracks are read in their order, fixed ones and those with keys, and what follows is left")
{
    const Bytes tracks =
        joined({bytes({0x85, 0x80, 0x80, 2}), // rotation, a quarter turn
                moving_track(Property::opacity, {{{}, 1, 255}, {{5632}, 2, 0}}), bytes({99})});
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
    CHECK_FALSE(cursor.rest().overrun());
    CHECK(cursor.rest().left() == 1);
}

TEST_CASE("keys of a smooth track have no laws")
{
    const Bytes tracks = joined({smooth_track(Property::z, {{{}, 3, 64}, {Time::frame(2), 4, -2}}),
                                 fixed_track(Property::pivot_x, 1)});
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

TEST_CASE("tracks with the same beats name them once")
{
    const Bytes tracks = joined({moving_track(Property::x, {{{}, 1, 5}, {{9}, 2, 6}}),
                                 fixed_track(Property::y, 7), bytes({2, 0}), value_bytes({8, 9}), // z
                                 bytes({0x43, 0}), value_bytes({1, 2})}); // rotation about x, smooth
    TrackCursor cursor{ByteReader{tracks}, 4};
    cursor.next();
    cursor.next();
    TrackKeyCursor z = cursor.next().keys;
    CHECK(z.next().laws == 1);
    const TrackKey last = z.next();
    CHECK(last.time == Time{9});
    CHECK(last.laws == 2);
    CHECK(last.value == 9);
    CHECK(z.at_end());
    TrackKeyCursor smooth = cursor.next().keys;
    CHECK(smooth.next().laws == 0);
    CHECK(smooth.next().time == Time{9});
    CHECK(cursor.rest().left() == 0);
}

TEST_CASE("tracks and keys that break off are noticed")
{
    for (const Bytes& whole :
         {moving_track(Property::x, {{{}, 1, 5}, {{9}, 2, 600}}), fixed_track(Property::x, 64)})
        for (std::size_t size = 0; size < whole.size(); ++size) {
            TrackCursor cut{ByteReader{std::span{whole}.first(size)}, 1};
            cut.next();
            CHECK(cut.rest().overrun());
        }
}

TEST_CASE("without tracks there is nothing to read") { CHECK(TrackCursor{}.at_end()); }

}
