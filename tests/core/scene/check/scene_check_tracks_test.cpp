#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/core/acceptance.hpp"
#include "tests/core/raw_drawing.hpp"

#include <doctest/doctest.h>
#include <vector>

/// Tracks of items, and paths that they follow.
namespace kfast::test {
namespace {

/// On a triangle, whose scene has three colours and one pair of laws.
bool takes_tracks(int count, const Bytes& tracks)
{
    RawScene scene;
    scene.law_count = 1;
    scene.laws = bytes({0x21});
    scene.items = tracked(count, tracks);
    return is_accepted(scene);
}

bool takes_value(Property property, std::int32_t value)
{
    return takes_tracks(1, fixed_track(property, value));
}

bool takes_track_keys(const std::vector<RawTrackKey>& keys)
{
    return takes_tracks(1, moving_track(Property::x, keys));
}

/// On an object that is stroked alone.
bool takes_stroked(int count, const Bytes& tracks)
{
    return takes_items(joined({bytes({0x14, count}), tracks, bytes({1, 16, 8}), one_key()}));
}

/// On an object that is filled and stroked.
bool takes_stroked_track(const Bytes& track)
{
    return takes_items(joined({bytes({0x1C, 1}), track, bytes({1, 1, 16, 8}), one_key()}));
}

}

TEST_CASE("tracks rise by their properties, of which there are twenty-nine")
{
    const Bytes x = bytes({0x80, 2});
    const Bytes y = bytes({0x81, 2});
    CHECK(takes_tracks(2, joined({x, y})));
    CHECK_FALSE(takes_tracks(2, joined({y, x})));
    CHECK_FALSE(takes_tracks(2, joined({x, x})));
    CHECK_FALSE(takes_tracks(1, bytes({0x80 | 29, 2})));
    CHECK_FALSE(takes_tracks(1, bytes({0xFF, 2})));
    CHECK_FALSE(takes_tracks(3, joined({x, y})));
}

TEST_CASE("values of tracks have ranges")
{
    const auto check_range = [](Property property, std::int32_t min, std::int32_t max) {
        CAPTURE(static_cast<int>(property));
        CHECK(takes_value(property, min));
        CHECK(takes_value(property, max));
        CHECK_FALSE(takes_value(property, min - 1));
        CHECK_FALSE(takes_value(property, max + 1));
    };
    for (const Property place :
         {Property::x, Property::y, Property::z, Property::pivot_x, Property::pivot_y, Property::order})
        check_range(place, -32768, 32767);
    for (const Property turn : {Property::rotation_x, Property::rotation_y, Property::rotation})
        check_range(turn, -1'048'576, 1'048'576);
    check_range(Property::scale_x, -262'144, 262'144);
    check_range(Property::scale_y, -262'144, 262'144);
    check_range(Property::opacity, 0, 255);
    check_range(Property::visible, 0, 1);
    check_range(Property::fill, 0, 2); // three colours
    CHECK_FALSE(takes_value(Property::x, (1 << 30) - 1));
}

TEST_CASE("tracks of colours and widths need what they colour")
{
    const Bytes fill = bytes({1, 0x8E, 2});
    const Bytes stroke = bytes({1, 0x8F, 2});
    const Bytes width = bytes({1, 0x90, 2});
    const auto on_filled = [](const Bytes& tracks) {
        return takes_items(joined({bytes({0x0C}), tracks, bytes({1}), one_key()}));
    };
    const auto on_stroked = [](const Bytes& tracks) {
        return takes_items(joined({bytes({0x14}), tracks, bytes({1, 16, 8}), one_key()}));
    };
    CHECK(on_filled(fill));
    CHECK_FALSE(on_filled(stroke));
    CHECK_FALSE(on_filled(width));
    CHECK_FALSE(on_stroked(fill));
    CHECK(on_stroked(stroke));
    CHECK(on_stroked(width));
    CHECK(on_stroked(joined({bytes({1, 0x90}), signed_varint(65535)})));
    CHECK_FALSE(on_stroked(joined({bytes({1, 0x90}), signed_varint(65536)})));
    CHECK_FALSE(on_stroked(bytes({1, 0x90, 1}))); // -1
    CHECK_FALSE(on_stroked(bytes({1, 0x8F, 6}))); // the fourth colour of three
    for (const Bytes& tracks : {fill, stroke, width}) {
        CHECK_FALSE(takes_items(joined({bytes({5}), tracks, bytes({0})})));
        RawScene scene;
        scene.add_symbol(triangle());
        scene.items = joined({bytes({6}), tracks, bytes({0})});
        CHECK_FALSE(is_accepted(scene));
    }
}

TEST_CASE("a beam may draw the outline of an object, its hatching, both or nothing")
{
    const auto takes_beam = [](const Bytes& style) { return takes_tracks(0x80, style); };
    CHECK(takes_beam(bytes({0})));
    CHECK(takes_beam(bytes({1})));
    CHECK(takes_beam(bytes({2, 8, 0})));
    CHECK(takes_beam(bytes({3, 0xFF, 0xFF, 0x03, 0xFF, 0xFF, 0x03})));
    CHECK_FALSE(takes_beam(bytes({4})));
    CHECK_FALSE(takes_beam(bytes({0xFF, 8, 0})));
    CHECK_FALSE(takes_beam(bytes({2, 7, 0})));
    CHECK_FALSE(takes_beam(bytes({2, 0x80, 0x80, 0x04, 0})));
    CHECK(takes_tracks(0x81, joined({fixed_track(Property::x, 5), bytes({2, 8, 0})})));
    CHECK_FALSE(takes_tracks(0x80, {}));
    SUBCASE("what is not filled is not hatched")
    {
        CHECK(takes_stroked(0x80, bytes({0})));
        CHECK_FALSE(takes_stroked(0x80, bytes({2, 8, 0})));
    }
    SUBCASE("groups are not drawn themselves")
    {
        RawScene scene;
        scene.items = bytes({0x05, 0x80, 0, 0});
        CHECK_FALSE(is_accepted(scene));
        scene.items = bytes({0x01, 0});
        CHECK(is_accepted(scene));
    }
}

TEST_CASE("keys of tracks rise in time and have known laws")
{
    constexpr Time last{kfb::max_time};
    CHECK(takes_track_keys({{{}, 1, 1}, {Time::frame(2), 0, 2}}));
    CHECK_FALSE(takes_track_keys({}));
    CHECK_FALSE(takes_track_keys({{{}, 0, 1}, {{}, 0, 2}}));
    CHECK_FALSE(takes_track_keys({{{}, 0, 1}, {{5}, 0, 2}, {{5}, 0, 3}}));
    CHECK_FALSE(takes_track_keys({{{}, 2, 1}, {Time::frame(2), 0, 2}})); // a law too many
    CHECK(takes_track_keys({{last, 0, 1}}));
    CHECK_FALSE(takes_track_keys({{last + Time::frame(1), 0, 1}}));
    CHECK_FALSE(takes_track_keys({{last, 0, 1}, {last + Time{1}, 0, 1}}));
    CHECK_FALSE(takes_track_keys({{{}, 0, 32768}}));
    CHECK_FALSE(takes_track_keys({{{}, 0, 1}, {Time::frame(2), 0, -32769}}));
}

TEST_CASE("beats have a form with a meaning, and times within the limits of the format")
{
    const auto takes_key_times = [](const Bytes& key_times) {
        return takes_tracks(1, joined({bytes({0}), key_times, bytes({0, 0})}));
    };
    CHECK(takes_key_times(bytes({2, 0x01, 0x02, 0x30})));                   // a bit for times, one for laws
    CHECK_FALSE(takes_key_times(bytes({2, 0x01, 0x14, 0x00, 0x10, 0x00}))); // laws of ten bits
    CHECK(takes_key_times(bytes({2, 0x41, 0x01, 0x40})));                   // in frames
    CHECK_FALSE(takes_key_times(joined({bytes({2, 0x1F, 0x00}), repeated(bytes({0xFF}), 8)})));
    CHECK_FALSE(takes_key_times(joined({bytes({2, 0xFF, 0x01}), repeated(bytes({0xFF}), 8)})));
    CHECK_FALSE(takes_key_times(bytes({2, 0x00, 0x00})));                            // both at 0
    CHECK_FALSE(takes_key_times(bytes({0xFF, 0xFF, 0xFF, 0xFF, 0x0F, 0x00, 0x00}))); // all at 0
    CHECK_FALSE(takes_key_times(joined({bytes({0xFF, 0xFF, 0xFF, 0xFF, 0x0F, 0x1F, 0x10}), Bytes(9)})));
}

TEST_CASE("a track may have the beats of the one before, if one has any")
{
    const Bytes x = moving_track(Property::x, {{{}, 1, 5}, {{7}, 0, 9}});
    const Bytes fixed = fixed_track(Property::y, 3);
    const Bytes again = joined({bytes({2, 0}), value_bytes({4, 44})});
    CHECK(takes_tracks(2, joined({x, again})));
    CHECK(takes_tracks(3, joined({x, fixed, again})));
    CHECK_FALSE(takes_tracks(1, again));
    CHECK_FALSE(takes_tracks(2, joined({fixed, again})));
}

TEST_CASE("only amounts may be smooth, and nothing that is fixed")
{
    for (int number = 0; number < static_cast<int>(property_count); ++number) {
        const auto property = static_cast<Property>(number);
        if (property == Property::along)
            continue; // has a path
        const Bytes smooth = smooth_track(property, {{{}, 0, 1}, {Time::frame(2), 0, 1}});
        CAPTURE(number);
        const bool is_mode = property == Property::trim_mode || property == Property::max_dashes;
        const bool is_amount =
            property < Property::order || property == Property::width || (cuts_strokes(property) && !is_mode);
        CHECK(takes_stroked_track(smooth) == is_amount);
        CHECK(takes_stroked_track(moving_track(property, {{{}, 0, 1}, {Time::frame(2), 0, 1}})) == !is_mode);
        CHECK_FALSE(takes_stroked_track(bytes({0xC0 | number, 2})));
    }
    SUBCASE("keys of smooth tracks rise in time and have values in their ranges")
    {
        const auto takes = [](const std::vector<RawTrackKey>& list) {
            return takes_tracks(1, smooth_track(Property::opacity, list));
        };
        CHECK(takes({{{}, 0, 255}, {{1}, 0, 0}}));
        CHECK_FALSE(takes({{{}, 0, 256}}));
        CHECK_FALSE(takes({{{}, 0, -1}}));
        CHECK_FALSE(takes({{{5}, 0, 1}, {{5}, 0, 2}}));
        CHECK_FALSE(takes({}));
        CHECK(takes({{{}, 9, 255}, {{1}, 9, 0}})); // they have no laws
    }
}

TEST_CASE("what is drawn in part or dashed is an object, by shares and lengths within their ranges")
{
    const auto takes = [](Property property, std::int32_t value) {
        return takes_stroked_track(fixed_track(property, value));
    };
    for (const Property share : {Property::trim_from, Property::trim_to}) {
        CHECK(takes(share, 0));
        CHECK(takes(share, 65536));
        CHECK_FALSE(takes(share, -1));
        CHECK_FALSE(takes(share, 65537));
    }
    CHECK(takes(Property::trim_offset, -1'048'576));
    CHECK_FALSE(takes(Property::trim_offset, 1'048'577));
    CHECK(takes(Property::trim_mode, 2));
    CHECK_FALSE(takes(Property::trim_mode, 3));
    for (const Property length : {Property::dash_1, Property::gap_1, Property::gap_3}) {
        CHECK(takes(length, 0));
        CHECK(takes(length, 1'048'576));
        CHECK_FALSE(takes(length, -1));
        CHECK_FALSE(takes(length, 1'048'577));
    }
    CHECK(takes(Property::dash_offset, -1'048'576));
    CHECK_FALSE(takes(Property::dash_offset, 1'048'577));
    CHECK(takes(Property::max_dashes, 1024));
    CHECK_FALSE(takes(Property::max_dashes, 1025));
    CHECK_FALSE(takes(Property::max_dashes, 0));
    CHECK_FALSE(takes_tracks(1, fixed_track(Property::dash_1, 64))); // not stroked
    const Bytes half = fixed_track(Property::trim_to, 32768);
    CHECK_FALSE(takes_items(joined({bytes({0x05, 1}), half, block({})}))); // a group
    RawScene scene;
    scene.add_symbol(triangle());
    scene.items = joined({bytes({0x06, 1}), half, bytes({0})});
    CHECK_FALSE(is_accepted(scene));
}

TEST_CASE("a path is one stroke with an extent, and each of its segments has a length")
{
    const auto takes_path = [](const scene::Drawing& drawing, const Bytes& path) {
        RawScene scene;
        scene.drawings = joined({scene.drawings, packed(drawing)});
        scene.items =
            joined({bytes({0x0C, 1}), fixed_track(Property::along, 7), path, bytes({1}), one_key()});
        return is_accepted(scene);
    };
    constexpr std::uint32_t offset = 11;
    const scene::Drawing corner{{polyline_of({{0, 0}, {160, 0}, {160, 160}})}};
    const scene::Drawing two{{corner.strokes[0], corner.strokes[0]}};
    const scene::Drawing point{{polyline_of({{0, 0}})}};
    CHECK(takes_path(corner, path_bytes(false, offset, {160, 160})));
    CHECK(takes_path(corner, path_bytes(true, offset, {1, 8'388'606})));
    CHECK_FALSE(takes_path(two, path_bytes(false, offset, {160, 160})));
    CHECK_FALSE(takes_path(two, path_bytes(false, offset, {160, 160, 160, 160})));
    CHECK_FALSE(takes_path(point, path_bytes(false, offset, {})));
    CHECK_FALSE(takes_path(corner, path_bytes(false, 10, {}))); // the empty drawing
    CHECK_FALSE(takes_path(corner, path_bytes(false, offset, {160})));
    CHECK_FALSE(takes_path(corner, path_bytes(false, offset, {160, 160, 1})));
    CHECK_FALSE(takes_path(corner, path_bytes(false, offset, {160, 0})));
    CHECK_FALSE(takes_path(corner, path_bytes(false, offset, {1, 8'388'607})));
    CHECK_FALSE(takes_path(corner, path_bytes(false, offset, {1, 0xFFFFFFFF})));
    CHECK_FALSE(takes_path(corner, path_bytes(false, 10'000, {160, 160})));
    CHECK_FALSE(takes_path(corner, path_bytes(false, 0xFFFFFFFF, {160, 160})));
    CHECK_FALSE(takes_path(corner, block(joined({bytes({2}), varint(offset), varint(160), varint(160)}))));
    CHECK_FALSE(takes_path(corner, block(joined({bytes({0}), varint(offset), varint(160), bytes({0x85})}))));
    CHECK_FALSE(takes_path(corner, {}));
    SUBCASE("whose drawing is whole")
    {
        Bytes cut = packed(corner);
        cut.pop_back();
        const Bytes too_wide = joined({bytes({1, 0, 0, 0, 31, 4}), repeated(bytes({0xFF}), 20)});
        for (const Bytes& drawing : {cut, too_wide}) {
            RawScene scene;
            scene.drawings = joined({scene.drawings, drawing});
            scene.items = joined({bytes({0x0C, 1}), fixed_track(Property::along, 7),
                                  path_bytes(false, offset, {160, 160}), bytes({1}), one_key()});
            CHECK_FALSE(is_accepted(scene));
        }
    }
}

TEST_CASE("groups and uses may follow a path, too, and a share of it is 0 to 1")
{
    const Bytes path = path_bytes(true, 0, {20, 20}); // along the triangle
    const auto takes_share = [&path](std::int32_t share) {
        return takes_items(joined({bytes({0x05, 1}), fixed_track(Property::along, share), path, block({})}));
    };
    CHECK(takes_share(0));
    CHECK(takes_share(65536));
    CHECK_FALSE(takes_share(-1));
    CHECK_FALSE(takes_share(65537));
    RawScene scene;
    scene.add_symbol(triangle());
    scene.items = joined({bytes({0x06, 1}), fixed_track(Property::along, 1), path, bytes({0})});
    CHECK(is_accepted(scene));
    scene.items =
        joined({bytes({0x06, 1}), fixed_track(Property::along, 1), path_bytes(true, 0, {20}), bytes({0})});
    CHECK_FALSE(is_accepted(scene));
}

}
