#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/core/acceptance.hpp"
#include "tests/core/raw_drawing.hpp"

#include <cstddef>
#include <doctest/doctest.h>
#include <initializer_list>
#include <vector>

namespace kfast::test {
namespace {

/// Of a filled object.
bool takes_keys(const std::vector<RawKey>& keys, const Bytes& laws = {}, int law_count = 0)
{
    RawScene scene;
    scene.law_count = static_cast<std::uint32_t>(law_count);
    scene.laws = laws;
    scene.items = joined({bytes({0x08, 1}), key_bytes(keys)});
    return is_accepted(scene);
}

/// Of an object.
bool takes_stroke(const Bytes& style) { return takes_items(joined({bytes({0x10}), style, one_key()})); }

bool takes_marks(const Bytes& marks)
{
    RawScene scene;
    scene.marks = marks;
    return is_accepted(scene);
}

/// Clips and events, without a clock.
bool takes_named(const Bytes& marks) { return takes_marks(joined({bytes({0}), marks})); }

bool takes_drawings(const Bytes& drawings)
{
    RawScene scene;
    scene.drawings = drawings;
    return is_accepted(scene);
}

}

TEST_CASE("what is put together by hand is a scene, and may be empty")
{
    CHECK(is_accepted({}));
    CHECK(takes_items(nothing()));
    CHECK(takes_items({}));
    CHECK(takes_items(group({})));
}

TEST_CASE("values of the header have ranges")
{
    const auto with = [](auto member, std::uint32_t value) {
        RawScene scene;
        scene.*member = value;
        return is_accepted(scene);
    };
    for (const auto side : {&RawScene::width, &RawScene::height}) {
        CHECK_FALSE(with(side, 0));
        CHECK(with(side, 1));
        CHECK(with(side, 2047));
        CHECK_FALSE(with(side, 2048));
    }
    CHECK_FALSE(with(&RawScene::ticks, 1023));
    CHECK(with(&RawScene::ticks, 1024));
    CHECK(with(&RawScene::ticks, kfb::max_time));
    CHECK_FALSE(with(&RawScene::ticks, kfb::max_time + 1));
    CHECK_FALSE(with(&RawScene::ticks, 0xFFFFFFFF));
    CHECK_FALSE(with(&RawScene::frame_rate, 0));
    CHECK(with(&RawScene::frame_rate, 1));
    CHECK(with(&RawScene::frame_rate, 1'000'000));
    CHECK_FALSE(with(&RawScene::frame_rate, 1'000'001));
    CHECK(with(&RawScene::loop, 2));
    CHECK_FALSE(with(&RawScene::loop, 3));
    CHECK_FALSE(with(&RawScene::camera, 15));
    CHECK(with(&RawScene::camera, 16));
    CHECK(with(&RawScene::camera, 32767));
    CHECK_FALSE(with(&RawScene::camera, 32768));
    CHECK(with(&RawScene::outline_bytes, 0));
    CHECK(with(&RawScene::outline_bytes, 4));
    CHECK(with(&RawScene::outline_bytes, 4'194'304));
    CHECK_FALSE(with(&RawScene::outline_bytes, 4'194'308));
    CHECK_FALSE(with(&RawScene::outline_bytes, 0xFFFFFFFC));
    CHECK(with(&RawScene::borders, 0));
    CHECK(with(&RawScene::borders, 1'048'576));
    CHECK_FALSE(with(&RawScene::borders, 1'048'577));
    CHECK_FALSE(with(&RawScene::borders, 0xFFFFFFFF));
    CHECK(with(&RawScene::cache_bytes, 4'194'304));
    CHECK_FALSE(with(&RawScene::cache_bytes, 4'194'308));
}

TEST_CASE("the background is opaque, and there is one")
{
    RawScene scene;
    scene.palette[3] = std::byte{254};
    CHECK_FALSE(is_accepted(scene));
    scene.palette.clear();
    scene.items.clear();
    CHECK_FALSE(is_accepted(scene));
}

TEST_CASE("clocks go by the time or by one before them, and have numbers in their ranges")
{
    // Driver, loop, delay, speed, length; 2 frames after the start, at normal speed
    const auto takes = [](const Bytes& clocks) { return takes_marks(clocks); };
    CHECK(takes(bytes({1, 0, 0, 0x80, 0x20, 0x80, 0x80, 8, 0})));
    CHECK_FALSE(takes(bytes({1, 0, 0, 0x80, 0x20, 0x80, 0x80, 8})));    // cut off
    CHECK_FALSE(takes(bytes({1, 0, 1, 0x80, 0x20, 0x80, 0x80, 8, 0}))); // repeats, without an end
    CHECK(takes(bytes({1, 0, 1, 0x80, 0x20, 0x80, 0x80, 8, 2})));
    CHECK_FALSE(takes(bytes({1, 0, 3, 0x80, 0x20, 0x80, 0x80, 8, 2}))); // no such loop
    CHECK_FALSE(takes(bytes({1, 0, 0, 0, 0xFF, 0xFF, 7, 0})));          // backwards, without an end
    CHECK(takes(bytes({1, 0, 0, 0, 0xFF, 0xFF, 7, 2})));
    CHECK(takes(bytes({1, 0, 0, 0, 0x80, 0x80, 0x80, 1, 2}))); // 16 times as fast
    CHECK_FALSE(takes(bytes({1, 0, 0, 0, 0x82, 0x80, 0x80, 1, 2})));
    CHECK_FALSE(takes(bytes({1, 1, 0, 0, 2, 2})));  // by an input
    CHECK_FALSE(takes(bytes({1, 33, 0, 0, 2, 2}))); // by itself
    CHECK(takes(bytes({2, 0, 0, 0, 2, 2, 33, 0, 0, 2, 2})));
    CHECK_FALSE(takes(bytes({2, 34, 0, 0, 2, 2, 0, 0, 0, 2, 2}))); // by a later one
    Bytes many = bytes({224});
    for (int i = 0; i < 224; ++i)
        many = joined({many, bytes({0, 0, 0, 2, 2})});
    CHECK_FALSE(takes(many));
    many[0] = std::byte{223};
    many.resize(many.size() - 5);
    CHECK(takes(many));
}

TEST_CASE("keys go by clocks that there are")
{
    RawScene scene;
    const auto takes = [&scene](Driver driver, Time last) {
        scene.items = tracked(1, joined({bytes({0}), track_keys({{{}, 0, 1}, {last, 0, 2}}, 0, driver)}));
        return is_accepted(scene);
    };
    CHECK_FALSE(takes(Driver::of_clock(0), {9}));
    scene.marks = bytes({1, 0, 0, 0, 2, 2});
    CHECK(takes(Driver::of_clock(0), {9}));
    CHECK(takes(Driver::of_clock(0), {kfb::max_time}));
    CHECK_FALSE(takes(Driver::of_clock(0), {kfb::max_time + 1}));
    CHECK_FALSE(takes(Driver::of_clock(1), {9}));
}

TEST_CASE("laws have a known kind and parameters in their ranges")
{
    const auto takes_laws = [](std::uint32_t count, const Bytes& laws) {
        RawScene scene;
        scene.law_count = count;
        scene.laws = laws;
        return is_accepted(scene);
    };
    CHECK(takes_laws(1, bytes({0x44})));
    CHECK_FALSE(takes_laws(1, bytes({0x09})));
    CHECK_FALSE(takes_laws(1, bytes({0x90})));
    CHECK_FALSE(takes_laws(1, bytes({0xE0})));
    CHECK(takes_laws(1, bytes({0xF4})));
    CHECK_FALSE(takes_laws(1, bytes({0xF9})));
    CHECK_FALSE(takes_laws(1, bytes({0xFF})));
    CHECK(takes_laws(1, bytes({0x05, 1, 0})));
    CHECK_FALSE(takes_laws(1, bytes({0x05, 0, 0})));
    CHECK(takes_laws(1, bytes({0xF7, 8, 2})));
    CHECK_FALSE(takes_laws(1, bytes({0xF7, 0, 2})));
    CHECK_FALSE(takes_laws(1, bytes({0xF7, 9, 2})));
    CHECK_FALSE(takes_laws(1, bytes({0xF7, 8, 3})));
    CHECK(takes_laws(1, bytes({0xF8, 0, 2, 9, 9, 9, 9, 9, 9, 0xFF, 0xFF})));
    CHECK_FALSE(takes_laws(1, bytes({0xF8, 1, 2, 9, 9, 9, 9, 9, 9, 0xFF, 0xFF})));
    CHECK_FALSE(takes_laws(1, bytes({0xF8, 0, 3, 9, 9, 9, 9, 9, 9, 0xFF, 0xFF})));
    CHECK(takes_laws(2, bytes({0x00, 0x60, 0x00, 0x20, 0x00, 0xC0, 0x00, 0x00, 0x00, 0x60})));
    CHECK_FALSE(takes_laws(2, bytes({0x00, 0x60, 0x01, 0x20, 0x00, 0xC0, 0x00, 0x00, 0x00, 0x60})));
    CHECK_FALSE(takes_laws(2, bytes({0x00, 0x60, 0x00, 0x20, 0xFF, 0xBF, 0x00, 0x00, 0x00, 0x60})));
    CHECK_FALSE(takes_laws(2, bytes({0x00, 0x60, 0x00, 0x20, 0x00, 0xC0, 0xFF, 0xFF, 0x00, 0x60})));
    CHECK_FALSE(takes_laws(2, bytes({0x00, 0x60, 0x00, 0x20, 0x00, 0xC0, 0x00, 0x00, 0x01, 0x60})));
}

TEST_CASE("clips have a name and lie within the scene")
{
    const auto takes_clip = [](const Bytes& clip) { return takes_named(joined({bytes({1}), clip})); };
    CHECK(takes_clip(bytes({1, 'a', 0, 20, 2})));
    CHECK(takes_clip(bytes({1, 'a', 18, 2, 0})));
    CHECK(takes_clip(bytes({1, 'a', 18, 3, 0}))); // one tick
    CHECK_FALSE(takes_clip(bytes({0, 0, 20, 0})));
    CHECK_FALSE(takes_clip(bytes({1, 'a', 2, 0, 0})));
    CHECK_FALSE(takes_clip(bytes({1, 'a', 0, 22, 0})));
    CHECK_FALSE(takes_clip(bytes({1, 'a', 18, 4, 0})));
    CHECK_FALSE(takes_clip(bytes({1, 'a', 22, 0xFF, 0xFF, 0xFF, 0xFF, 0x0F, 0})));
    CHECK_FALSE(takes_clip(bytes({1, 'a', 0, 20, 3})));
    CHECK_FALSE(takes_clip(bytes({1, 'a', 0, 20}))); // the loop is missing
    CHECK_FALSE(takes_named(bytes({2, 1, 'a', 0, 20, 0})));
}

TEST_CASE("events have a name and come within the scene")
{
    CHECK(takes_marks({}));
    CHECK(takes_marks(bytes({0})));
    CHECK(takes_named(bytes({0})));
    CHECK(takes_named(bytes({0, 20, 1, 'a', 0, 1, 'b'})));
    CHECK_FALSE(takes_named(bytes({0, 22, 1, 'a'})));
    CHECK_FALSE(takes_named(bytes({0, 20, 1, 'a', 3, 1, 'b'}))); // one tick later
    CHECK_FALSE(takes_named(bytes({0, 2, 0})));
    CHECK_FALSE(takes_named(bytes({0, 2, 2, 'a'})));
    CHECK_FALSE(takes_named(bytes({0, 2})));
}

TEST_CASE("items have no bits without a meaning")
{
    CHECK_FALSE(takes_items(bytes({0x88, 1, 0, 0})));
    CHECK_FALSE(takes_items(bytes({3})));
    CHECK_FALSE(takes_items(bytes({3, 0})));
    for (const int bit : {0x08, 0x10, 0x20, 0x40, 0x80})
        CHECK_FALSE(takes_items(bytes({1 | bit, 0})));
    CHECK_FALSE(takes_items(bytes({0x00, 0, 0}))); // neither filled nor stroked
    CHECK_FALSE(takes_items(bytes({0x05, 0, 0}))); // tracks, but none
}

TEST_CASE("items end where their section ends")
{
    const std::vector<RawKey> keys{{.drawing = 10}, {.time = {77}}, {.time = {999}, .drawing = 10}};
    const Bytes moving =
        joined({bytes({0x0C, 1, 0}), track_keys({{{}, 0, -99}, {{3}, 0, 99}}), bytes({1}), key_bytes(keys)});
    for (const Bytes& whole : {triangle(), moving}) {
        CHECK(takes_items(whole));
        for (std::size_t count = 1; count < whole.size(); ++count) {
            const Bytes items(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(count));
            CHECK_FALSE(takes_items(items));
            CHECK_FALSE(takes_items(group(items)));
        }
    }
    CHECK_FALSE(takes_items(joined({triangle(), bytes({0})})));
    CHECK_FALSE(takes_items(bytes({1, 1})));
    CHECK_FALSE(takes_items(bytes({2})));
    CHECK_FALSE(takes_items(bytes({0x0C})));
}

TEST_CASE("keys of objects rise in time, have known laws, and drawings that are there")
{
    constexpr Time last{kfb::max_time};
    CHECK(takes_keys({{.time = {}}, {.time = {1}}}));
    CHECK_FALSE(takes_keys({{.time = {1}}, {.time = {1}}}));
    CHECK(takes_keys({{.laws = 1}}, bytes({0x21}), 1));
    CHECK_FALSE(takes_keys({{.laws = 2}}, bytes({0x21}), 1));
    CHECK(takes_keys({{.time = last}}));
    CHECK_FALSE(takes_keys({{.time = last + Time::frame(1)}}));
    CHECK(takes_keys({{.drawing = 10}}));
    CHECK(takes_keys({{.drawing = 10}, {.time = {1}, .drawing = 0}}));
    CHECK_FALSE(takes_keys({{.drawing = 11}})); // behind the last drawing
    CHECK_FALSE(takes_keys({{.drawing = 10}, {.time = {1}, .drawing = 11}}));
    CHECK_FALSE(takes_keys({{.drawing = 0xFFFFFFFF}}));
}

TEST_CASE("arrival drawings are there")
{
    CHECK(takes_items(bytes({0x48, 1, 0, 20, 0})));
    CHECK_FALSE(takes_items(bytes({0x48, 1, 0, 0, 22})));
    CHECK_FALSE(takes_items(bytes({0x48, 1, 0, 0})));
}

TEST_CASE("styles have known words, colours of the palette and parameters in their ranges")
{
    CHECK(takes_items(bytes({0x28, 2, 0, 0})));
    CHECK_FALSE(takes_items(bytes({0x28, 3, 0, 0}))); // the fourth colour of three
    CHECK(takes_stroke(bytes({2, 1, 0x0A})));
    CHECK_FALSE(takes_stroke(bytes({3, 1, 0x0A})));
    CHECK_FALSE(takes_stroke(bytes({2, 0, 0x0A}))); // no width
    CHECK(takes_stroke(joined({bytes({2}), varint(65535), bytes({0x0A})})));
    CHECK_FALSE(takes_stroke(joined({bytes({2}), varint(65536), bytes({0x0A})})));
    CHECK_FALSE(takes_stroke(joined({bytes({2}), varint(0xFFFFFFFF), bytes({0x0A})})));
    CHECK_FALSE(takes_stroke(bytes({2, 1, 0x0B}))); // a fourth cap
    CHECK_FALSE(takes_stroke(bytes({2, 1, 0x0E}))); // a fourth join
    for (const int bit : {0x10, 0x20, 0x40, 0x80})
        CHECK_FALSE(takes_stroke(bytes({2, 1, 0x0A | bit})));
    CHECK(takes_stroke(bytes({2, 1, 0x00, 8})));
    CHECK_FALSE(takes_stroke(bytes({2, 1, 0x00, 7}))); // a miter shorter than the width
}

TEST_CASE("drawings are whole, and their points have coordinates of 16 bits")
{
    CHECK_FALSE(takes_drawings({}));
    CHECK_FALSE(takes_drawings(bytes({1})));
    const auto from = [](std::int32_t x, const Bytes& form) {
        return joined({bytes({1}), signed_varint(x), bytes({64}), form});
    };
    const Bytes form = bytes({0, 6, 4, 0x40, 0x0C, 0x10}); // 1 px to the right and back
    CHECK(takes_drawings(from(32, form)));
    CHECK_FALSE(takes_drawings(from(32, bytes({0, 6, 4, 0x40, 0x0C}))));
    CHECK_FALSE(takes_drawings(from(32, bytes({0x0C, 6, 4, 0x40, 0x0C, 0x10}))));
    CHECK_FALSE(takes_drawings(from(32, bytes({0, 0, 4, 0x40, 0x0C, 0x10}))));
    CHECK(takes_drawings(from(32'751, form)));       // to 32767
    CHECK_FALSE(takes_drawings(from(32'752, form))); // to 32768
    CHECK(takes_drawings(from(-32'768, form)));
    CHECK_FALSE(takes_drawings(from(-32'769, form)));
    CHECK_FALSE(takes_drawings(joined({varint(65536), Bytes(70'000)}))); // points
}

TEST_CASE("symbols use symbols in front of them")
{
    RawScene scene;
    scene.add_symbol(triangle());
    scene.add_symbol(use(0));
    scene.items = use(1);
    CHECK(is_accepted(scene));
    scene.items = use(2);
    CHECK_FALSE(is_accepted(scene)); // missing
    scene.items = use(1);
    SUBCASE("not itself")
    {
        scene.add_symbol(use(2));
        CHECK_FALSE(is_accepted(scene));
    }
    SUBCASE("not a later one, nor within a group")
    {
        RawScene wrong;
        wrong.add_symbol(group(use(1)));
        wrong.add_symbol(triangle());
        CHECK_FALSE(is_accepted(wrong));
    }
    SUBCASE("what no item uses is looked at, too")
    {
        scene.add_symbol(bytes({3}));
        CHECK_FALSE(is_accepted(scene));
    }
}

TEST_CASE("the section of symbols holds as many as the header says")
{
    RawScene scene;
    scene.add_symbol(triangle());
    scene.add_symbol(triangle());
    --scene.symbol_count;
    CHECK_FALSE(is_accepted(scene)); // bytes behind the last
    scene.symbol_count += 2;
    CHECK_FALSE(is_accepted(scene)); // one is missing
    RawScene cut;
    cut.symbol_count = 1;
    cut.symbols = joined({bytes({9}), triangle()});
    CHECK_FALSE(is_accepted(cut));
}

}
