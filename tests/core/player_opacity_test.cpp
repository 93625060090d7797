#include "core/pixel/pixel_coding.hpp"
#include "core/player.hpp"

#include "tests/core/player_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>

/// What is transparent: pictures against a reference that renders everything opaque and blends the pictures.
namespace kfast::test {
namespace {

/// The channels of all pixels, one or three for each.
using Channels = std::vector<int>;

/// The channels of a pixel as PixelCoding loads it.
void append(Channels& channels, PixelFormat format, std::uint32_t pixel)
{
    const auto part = [pixel](int shift, std::uint32_t max) {
        return static_cast<int>(pixel >> shift & max);
    };
    switch (format) {
    case PixelFormat::rgb565:
    case PixelFormat::rgb565_be:
        channels.insert(channels.end(), {part(11, 31), part(5, 63), part(0, 31)});
        break;
    case PixelFormat::rgb444:
        channels.insert(channels.end(), {part(8, 15), part(4, 15), part(0, 15)});
        break;
    case PixelFormat::rgb666:
        channels.insert(channels.end(), {part(12, 63), part(6, 63), part(0, 63)});
        break;
    default:
        channels.push_back(static_cast<int>(pixel));
    }
}

/// Of a picture whose rows have no gaps.
template <PixelFormat format>
Channels channels_of(const Bytes& picture)
{
    Channels channels;
    const auto pixels = static_cast<int>(picture.size() * 8) / bits_per_pixel(format);
    for (int i = 0; i < pixels; ++i)
        append(channels, format, PixelCoding<format>::load(picture.data(), i));
    return channels;
}

const std::string backdrop = "object sky fill=\"#3060c0\" { rect 0 0 40 18 }\n"
                             "object hill fill=\"#60a020\" { circle 25 35 r=19 }\n";

template <PixelFormat format>
Channels drawn(const std::string& items, Time time = {})
{
    PlayerFixture fixture{"kfast 1\ncanvas 40 40 background=\"#102030\" frames=20\n" + items, {40, 40}};
    return channels_of<format>(fixture.picture<format>(time));
}

constexpr bool is_rgb565(PixelFormat format)
{
    return format == PixelFormat::rgb565 || format == PixelFormat::rgb565_be;
}

/// In 32 steps of RGB565, halves up.
int mixed(int under, int over, int opacity)
{
    const double steps = std::floor((opacity * 32 + 127) / 255);
    return static_cast<int>(std::floor(under + (over - under) * steps / 32 + 0.5));
}

template <PixelFormat format>
Channels mixed(const Channels& under, const Channels& over, int opacity)
{
    Channels result(under.size());
    for (std::size_t i = 0; i < under.size(); ++i)
        result[i] = is_rgb565(format)
                        ? mixed(under[i], over[i], opacity)
                        : static_cast<int>(std::lround(under[i] + (over[i] - under[i]) * opacity / 255.0));
    return result;
}

/// RGB565 is mixed as it is shown. Other formats are mixed in 8 bits a channel: a mixture of what is shown
/// may be rounded to another step, as often as it is mixed.
template <PixelFormat format>
void expect(const Channels& drawn, const Channels& expected, int mixtures = 1)
{
    REQUIRE(drawn.size() == expected.size());
    int worst = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        worst = std::max(worst, std::abs(drawn[i] - expected[i]));
    CHECK(worst <= (is_rgb565(format) ? 0 : mixtures));
}

const std::string badge = "object badge fill=red stroke=white width=4 join=round";
const std::string badge_shape = " { circle 17 20 r=11 }\n";
const std::string overlapping = "object a fill=red { circle 14 18 r=9 }\n"
                                "object b fill=white stroke=black width=3 { rect 15.5 10 17 21.25 }\n";

constexpr int half = 128; ///< 0.5 of 255
constexpr int third = 77; ///< 0.3

}

TEST_CASE("a colour's opacity mixes it with what is below, by its coverage")
{
    PlayerFixture fixture{"kfast 1\ncanvas 4 1 background=\"#ff8000\"\n"
                          "object o fill=\"#0080ff80\" { rect 0 0 1 1; rect 2.5 0 0.5 1 }",
                          {4, 1}};
    SUBCASE("rgb565")
    {
        // ff8000 is 31, 32, 0; 0080ff is 0, 32, 31; a half-covered pixel has half of 128
        CHECK(channels_of<PixelFormat::rgb565>(fixture.picture({})) ==
              Channels{mixed(31, 0, 128), 32, mixed(0, 31, 128), 31, 32, 0, //
                       mixed(31, 0, 64), 32, mixed(0, 31, 64), 31, 32, 0});
    }
    SUBCASE("grey4")
    {
        // 152 below, 104 above: 128 and 140 are 8
        CHECK(row_text(fixture.picture<PixelFormat::grey4>({})) == "8989");
    }
}

TEST_CASE("the opacity of an object with one layer multiplies with that of its colour")
{
    const auto levels = [](const std::string& object) {
        return row_text(
            PlayerFixture{"kfast 1\ncanvas 2 1\n" + object, {2, 1}}.picture<PixelFormat::grey4>({}));
    };
    CHECK(levels("object o fill=white opacity=0.5 { rect 0 0 2 1 }") == "88");
    CHECK(levels("object o fill=\"#ffffff80\" opacity=0.5 { rect 0 0 2 1 }") == "44");
    CHECK(levels("object o stroke=\"#ffffff80\" width=2 opacity=0.5 { line 0 0 2 0 }") == "44");
    CHECK(levels(
              "object o fill=\"#ffffff80\" { rect 0 0 2 1 }\nobject p fill=\"#ffffff80\" { rect 1 0 1 1 }") ==
          "8b");
}

TEST_CASE("a layer alone in groups and symbols fades by its colour, with nothing to blend")
{
    const std::string symbol = "kfast 1\ncanvas 2 1\nsymbol s { object o fill=white { rect 0 0 2 1 } }\n";
    const auto expect = [&](const std::string& items, const std::string& levels) {
        CAPTURE(items);
        PlayerFixture fixture{symbol + items, {2, 1}};
        CHECK(row_text(fixture.picture<PixelFormat::grey4>({})) == levels);
        CHECK(fixture.scene.paint_steps() == 1);
        CHECK(fixture.scene.blended_depth() == 0);
    };
    expect("use s opacity=0.5", "88");
    expect("group opacity=0.5 { use s opacity=0.5 }", "44");
    expect("group opacity=0.5 { group opacity=0.5 { use s x=1 } }", "04");
    CHECK(PlayerFixture{symbol + "group opacity=0.5 { use s; use s x=1 }", {2, 1}}.scene.blended_depth() ==
          1);
}

TEST_CASE("a layer alone in groups fades with them though it stands still")
{
    PlayerFixture fixture{
        "kfast 1\ncanvas 2 1 frames=16\n"
        "group { key 0 opacity=1; key 15 opacity=0\n object o fill=white { rect 0 0 2 1 } }\n",
        {2, 1}};
    Bytes pixels(1);
    for (int frame = 0; frame < 16; ++frame) {
        fixture.player.show(Time::frame(frame));
        const auto changes = fixture.player.draw_changes<PixelFormat::grey4>(pixels, {2, 1}, 0);
        REQUIRE(changes.size() == 1);
        CHECK(changes.front().pixels.front() == std::byte((15 - frame) * 0x11));
        fixture.player.draw_changes<PixelFormat::grey4>(pixels, {2, 1}, 0);
    }
}

TEST_CASE("a layer in as many groups as there may be fades by its colour")
{
    std::string text = "object o fill=white { rect 0 0 2 1 }";
    for (std::uint32_t depth = 0; depth < kfb::max_depth; ++depth)
        text = "group opacity=0.5 { " + text + " }";
    PlayerFixture fixture{"kfast 1\ncanvas 2 1\n" + text, {2, 1}};
    CHECK(fixture.scene.paint_steps() == 1);
    CHECK(fixture.scene.blended_depth() == 0);
}

TEST_CASE("an object's own colours let its fill shine through its stroke, its opacity does not")
{
    const auto levels = [](const std::string& properties) {
        return row_text(PlayerFixture{
            "kfast 1\ncanvas 6 1\nobject o " + properties + " { rect 2 -9 9 19 }",
            {6, 1}}.picture<PixelFormat::grey4>({}));
    };
    CHECK(levels("fill=white stroke=\"#333333\" width=2") == "033fff");
    CHECK(levels("fill=white stroke=\"#333333\" width=2 opacity=0.5") == "022888");
    CHECK(levels("fill=white stroke=\"#33333380\" width=2") == "029fff");
}

TEST_CASE_TEMPLATE("a fill with a stroke fades as one picture", Format,
                   std::integral_constant<PixelFormat, PixelFormat::rgb565>,
                   std::integral_constant<PixelFormat, PixelFormat::rgb565_be>,
                   std::integral_constant<PixelFormat, PixelFormat::rgb444>,
                   std::integral_constant<PixelFormat, PixelFormat::rgb666>,
                   std::integral_constant<PixelFormat, PixelFormat::grey4>)
{
    constexpr PixelFormat format = Format::value;
    const Channels below = drawn<format>(backdrop);
    const Channels opaque = drawn<format>(backdrop + badge + badge_shape);
    REQUIRE(opaque != below);
    expect<format>(drawn<format>(backdrop + badge + " opacity=0.5" + badge_shape),
                   mixed<format>(below, opaque, half));
    expect<format>(drawn<format>(backdrop + badge + " opacity=0.3" + badge_shape),
                   mixed<format>(below, opaque, third));
}

TEST_CASE_TEMPLATE("groups and uses fade as one picture, overlaps inside do not show", Format,
                   std::integral_constant<PixelFormat, PixelFormat::rgb565>,
                   std::integral_constant<PixelFormat, PixelFormat::rgb565_be>,
                   std::integral_constant<PixelFormat, PixelFormat::rgb444>,
                   std::integral_constant<PixelFormat, PixelFormat::rgb666>,
                   std::integral_constant<PixelFormat, PixelFormat::grey4>)
{
    constexpr PixelFormat format = Format::value;
    const Channels below = drawn<format>(backdrop);
    const Channels opaque = drawn<format>(backdrop + overlapping);
    REQUIRE(opaque != below);
    const Channels expected = mixed<format>(below, opaque, third);
    expect<format>(drawn<format>(backdrop + "group opacity=0.3 {\n" + overlapping + "}\n"), expected);
    expect<format>(drawn<format>(backdrop + "symbol s {\n" + overlapping + "}\nuse s opacity=0.3\n"),
                   expected);
    expect<format>(
        drawn<format>(backdrop + "group { group { group opacity=0.3 {\n" + overlapping + "} } }\n"),
        expected);
}

TEST_CASE_TEMPLATE("what fades within what fades is mixed from the inside out", Format,
                   std::integral_constant<PixelFormat, PixelFormat::rgb565>,
                   std::integral_constant<PixelFormat, PixelFormat::rgb565_be>,
                   std::integral_constant<PixelFormat, PixelFormat::rgb444>,
                   std::integral_constant<PixelFormat, PixelFormat::rgb666>,
                   std::integral_constant<PixelFormat, PixelFormat::grey4>)
{
    constexpr PixelFormat format = Format::value;
    const std::string lower = "object low fill=yellow { rect 5 5 20 20 }\n";
    const Channels p0 = drawn<format>(backdrop);
    const Channels p1 = drawn<format>(backdrop + lower);
    const Channels p2 = drawn<format>(backdrop + lower + overlapping);
    SUBCASE("two levels")
    {
        expect<format>(drawn<format>(backdrop + "group opacity=0.5 {\n" + lower + "group opacity=0.3 {\n" +
                                     overlapping + "} }\n"),
                       mixed<format>(p0, mixed<format>(p1, p2, third), half), 2);
    }
    SUBCASE("three levels: the innermost is an object with a fill and a stroke")
    {
        const Channels p3 = drawn<format>(backdrop + lower + badge + badge_shape);
        expect<format>(drawn<format>(backdrop + "group opacity=0.5 { group opacity=0.3 {\n" + lower + badge +
                                     " opacity=0.5" + badge_shape + "} }\n"),
                       mixed<format>(p0, mixed<format>(p0, mixed<format>(p1, p3, half), third), half), 2);
    }
    SUBCASE("two beside each other: the second is blended with what the first has left")
    {
        const std::string upper =
            "object all fill=olive { rect 0 0 40 40 }\nobject up fill=blue { circle 20 22.5 r=9 }\n";
        expect<format>(drawn<format>(backdrop + "group opacity=0.3 {\n" + lower + overlapping +
                                     "}\ngroup opacity=0.5 {\n" + upper + "}\n"),
                       mixed<format>(mixed<format>(p0, p2, third), drawn<format>(upper), half), 2);
    }
}

TEST_CASE("what fades on a panel of one bit is lit where it is brighter than half")
{
    for (const std::string& items :
         {badge + " opacity=0.5" + badge_shape, "group opacity=0.3 {\n" + overlapping + "}\n",
          "group opacity=0.5 { group opacity=0.3 {\n" + badge + " opacity=0.5" + badge_shape + overlapping +
              "} }\n"}) {
        CAPTURE(items);
        Channels levels = drawn<PixelFormat::grey4>(backdrop + items); // of 15
        for (int& level : levels)
            level = level > 7 ? 1 : 0;
        CHECK(drawn<PixelFormat::mono1>(backdrop + items) == levels);
    }
}

TEST_CASE("an opacity that has keys fades to nothing and comes back whole")
{
    constexpr auto format = PixelFormat::rgb565;
    const std::string fading =
        backdrop + "group { key 0 opacity=1; key 10 opacity=0; key 20 opacity=1\n" + overlapping + "}\n";
    const Channels below = drawn<format>(backdrop);
    const Channels opaque = drawn<format>(backdrop + overlapping);
    for (int frame = 0; frame < 20; ++frame) {
        const auto opacity = static_cast<int>(std::floor(25.5 * std::abs(frame - 10) + 0.5)); // halves up
        CHECK(drawn<format>(fading, Time::frame(frame)) == mixed<format>(below, opaque, opacity));
    }
}

TEST_CASE("what has no opacity or is invisible is not even traced")
{
    for (const std::string hidden : {"opacity=0", "visible=#false", "opacity=0.5 visible=#false"}) {
        CAPTURE(hidden);
        for (const std::string& items :
             {"group " + hidden + " {\n" + overlapping + "}\n", badge + " " + hidden + badge_shape,
              "symbol s {\n" + overlapping + "}\nuse s " + hidden + "\n",
              "object one fill=red " + hidden + badge_shape}) {
            PlayerFixture fixture{"kfast 1\ncanvas 40 40\n" + items, {40, 40}};
            CHECK(fixture.player.picture().outlines.needed_bytes() == 0);
            CHECK(fixture.player.picture().step_count == 0);
            CHECK(fixture.picture({}) == Bytes(40 * 40 * 2));
        }
    }
}

TEST_CASE("only what is transparent at the moment is blended")
{
    PlayerFixture fixture{"kfast 1\ncanvas 40 40 frames=20\n"
                          "group { key 0 opacity=1; key 10 opacity=0.5\n" +
                              overlapping + "}\n",
                          {40, 40}};
    CHECK(fixture.scene.paint_steps() == 5);
    CHECK(fixture.player.picture().step_count == 3);
    fixture.player.show(Time::frame(5));
    CHECK(fixture.player.picture().step_count == 5);
}

}
