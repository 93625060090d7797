#include "core/scene/check/scene_check.hpp"
#include "core/scene/kfb_limits.hpp"
#include "tests/core/acceptance.hpp"
#include "tests/core/raw_label.hpp"

#include <doctest/doctest.h>

/// What texts and labels may be.
namespace kfast::test {
namespace {

/// Two glyphs.
RawLabel label()
{
    RawLabel label;
    label.drawings = {0, 10};
    label.advances = {4096, 8192};
    return label;
}

RawScene scene_with(const Bytes& item, const Bytes& input = text_input_bytes("t", 8, 2, U'a', {0, 1}))
{
    RawScene scene;
    scene.input_count = 1;
    scene.inputs = input;
    scene.items = item;
    return scene;
}

bool takes(const RawLabel& label) { return is_accepted(scene_with(label.item())); }

bool takes_text(int max, int count, std::initializer_list<int> default_value)
{
    RawScene scene;
    scene.input_count = 1;
    scene.inputs = text_input_bytes("t", max, count, U'a', default_value);
    return is_accepted(scene);
}

}

TEST_CASE("a text has a length, glyphs, and a usual text of these")
{
    CHECK(takes_text(1, 1, {}));
    CHECK(takes_text(60, 255, {254}));
    CHECK(takes_text(3, 2, {0, 1, 0}));
    CHECK_FALSE(takes_text(0, 1, {}));
    CHECK_FALSE(takes_text(61, 1, {}));
    CHECK_FALSE(takes_text(3, 0, {}));
    CHECK_FALSE(takes_text(3, 2, {0, 1, 0, 1}));
    CHECK_FALSE(takes_text(3, 2, {2}));
    RawScene scene = scene_with(triangle(), text_input_bytes("", 8, 2, U'a'));
    CHECK_FALSE(is_accepted(scene));
    scene.inputs = text_input_bytes("t", 8, 2, U'a', {0, 1});
    CHECK(is_accepted(scene));
    scene.inputs.pop_back();
    CHECK_FALSE(is_accepted(scene));
}

TEST_CASE("a label shows a text of as many glyphs")
{
    CHECK(takes(label()));
    CHECK_FALSE(is_accepted(scene_with(label().item(1))));
    CHECK_FALSE(is_accepted(scene_with(label().item(), input_bytes("t"))));
    CHECK_FALSE(is_accepted(scene_with(label().item(), text_input_bytes("t", 8, 3, U'a'))));
    CHECK_FALSE(is_accepted(scene_with(label().item(), text_input_bytes("t", 8, 1, U'a'))));
    Bytes unknown = label().item();
    unknown[1] = std::byte{9};
    CHECK_FALSE(is_accepted(scene_with(unknown)));
}

TEST_CASE("a label has a known place, drawings and nothing else")
{
    RawLabel other = label();
    other.align = 3;
    CHECK_FALSE(takes(other));
    other = label();
    other.x = -32768;
    other.y = 32767;
    CHECK(takes(other));
    other.x = -32769;
    CHECK_FALSE(takes(other));
    other.x = 0;
    other.y = 32768;
    CHECK_FALSE(takes(other));
    other = label();
    other.drawings[1] = 11; // behind the section
    CHECK_FALSE(takes(other));
    other.drawings[1] = -1;
    CHECK_FALSE(takes(other));
    const Bytes style = bytes({0x0B, 1, 0, 1});
    const Bytes inside = label().bytes();
    CHECK(is_accepted(scene_with(joined({style, block(inside)}))));
    CHECK_FALSE(is_accepted(scene_with(joined({style, block(joined({inside, bytes({0})}))}))));
    Bytes shorter = inside;
    shorter.pop_back();
    CHECK_FALSE(is_accepted(scene_with(joined({style, block(shorter)}))));
    CHECK_FALSE(is_accepted(scene_with(joined({bytes({0x0B, 1, 0, 9}), block(inside)})))); // no such colour
    CHECK_FALSE(
        is_accepted(scene_with(joined({bytes({0x03, 1, 0}), block(inside)})))); // neither fill nor stroke
    CHECK_FALSE(is_accepted(scene_with(joined({bytes({0x4B, 1, 0, 1}), block(inside)}))));
}

TEST_CASE("the longest text finds room, in either direction")
{
    constexpr std::int32_t max = kfb::max_text_width / 8;
    RawLabel wide = label();
    wide.advances = {max, 0};
    CHECK(takes(wide));
    wide.advances = {-max, max};
    CHECK(takes(wide));
    wide.spacing = 1;
    CHECK_FALSE(takes(wide));
    wide.advances = {-max + 1, 0};
    CHECK(takes(wide));
    wide.spacing = -1;
    wide.pairs = {{0, 1, 1}};
    CHECK_FALSE(takes(wide));
    wide.spacing = 0;
    CHECK(takes(wide));
    wide.pairs = {{0, 1, -2}};
    CHECK_FALSE(takes(wide));
    wide = label();
    wide.spacing = -(1 << 30);
    CHECK_FALSE(takes(wide));
    wide = label();
    wide.advances = {1 << 30, 0};
    CHECK_FALSE(takes(wide));
}

TEST_CASE("pairs rise and are of glyphs that there are")
{
    RawLabel kerned = label();
    kerned.pairs = {{0, 0, 5}, {0, 1, 6}, {1, 0, 7}, {1, 1, 8}};
    CHECK(takes(kerned));
    kerned.pairs = {{0, 1, 5}, {0, 0, 6}};
    CHECK_FALSE(takes(kerned));
    kerned.pairs = {{0, 1, 5}, {0, 1, 6}};
    CHECK_FALSE(takes(kerned));
    kerned.pairs = {{2, 0, 5}};
    CHECK_FALSE(takes(kerned));
    kerned.pairs = {{0, 2, 5}};
    CHECK_FALSE(takes(kerned));
}

namespace {

/// Of 14 glyphs: those of a number, and one that stands around it.
RawLabel number_label()
{
    RawLabel label;
    label.drawings = std::vector<std::int32_t>(14, 0);
    label.advances = std::vector<std::int32_t>(14, 4096);
    label.format = {.decimals = 1, .before = {13}, .behind = {13, 3}};
    return label;
}

bool takes_number(const RawLabel& label) { return is_accepted(scene_with(label.item(), input_bytes("n"))); }

bool takes_format(const RawFormat& format)
{
    RawLabel label = number_label();
    label.format = format;
    return takes_number(label);
}

}

TEST_CASE("a label shows a number, with a format")
{
    CHECK(takes_number(number_label()));
    CHECK_FALSE(is_accepted(scene_with(number_label().item())));
    CHECK_FALSE(is_accepted(scene_with(number_label().item(), text_input_bytes("t", 8, 14, U'a'))));
    RawLabel other = number_label();
    other.format.reset();
    CHECK_FALSE(takes_number(other));
    other = number_label();
    other.align = 8;
    CHECK_FALSE(takes_number(other));
    other = number_label();
    other.drawings.resize(12);
    other.advances.resize(12);
    other.format = RawFormat{};
    CHECK_FALSE(takes_number(other));
    Bytes shorter = number_label().bytes();
    shorter.pop_back();
    CHECK_FALSE(is_accepted(scene_with(joined({bytes({0x0B, 1, 0, 1}), block(shorter)}), input_bytes("n"))));
}

TEST_CASE("a format has digits, and glyphs that there are")
{
    CHECK(takes_format({.decimals = 3, .digits = 10, .places = 10}));
    CHECK_FALSE(takes_format({.decimals = 4}));
    CHECK_FALSE(takes_format({.digits = 0}));
    CHECK_FALSE(takes_format({.digits = 11}));
    CHECK_FALSE(takes_format({.places = 11}));
    CHECK_FALSE(takes_format({.before = {14}}));
    CHECK_FALSE(takes_format({.behind = {0, 255}}));
    CHECK(takes_format({.before = std::vector<int>(40, 13), .behind = std::vector<int>(5, 13)}));
    CHECK_FALSE(takes_format({.before = std::vector<int>(40, 13), .behind = std::vector<int>(6, 13)}));
}

TEST_CASE("the longest number finds room")
{
    RawLabel wide = number_label(); // x0.0x3
    wide.advances[5] = kfb::max_text_width / 6;
    CHECK(takes_number(wide));
    ++wide.advances[5];
    CHECK_FALSE(takes_number(wide));
}

TEST_CASE("keys do not go by a text")
{
    RawScene scene =
        scene_with(tracked(1, joined({bytes({0}), track_keys({{{0}, 0, 1}, {{9}, 0, 2}}, 0, {1})})));
    CHECK_FALSE(is_accepted(scene));
    scene.inputs = input_bytes("t");
    CHECK(is_accepted(scene));
}

}
