#include "core/player.hpp"

#include "core/bytes/crc32.hpp"
#include "tests/core/everything.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

constexpr std::string_view busy_scene = R"(
kfast 1
canvas 60 40 background="#203040" frames=30
object morph fill="#ff8000" stroke=white width=3 cap=round join=round {
    key 0 law=accelerate { circle 15 20 r=12 }
    key 10 law-x=decelerate law-y=accelerate-decelerate { polygon 10 3 17 10 10 17 3 10; rect 30 20 20 15; line 5 35 55 35 }
    key 20 { path "M 5 5 C 60 0 0 40 55 35 Q 30 0 5 30 Z" }
    key 25 { empty }
    key 30 { circle 15 20 r=12 }
}
object zigzag stroke="#00ff80" width=5 cap=square join=miter {
    key 0 { line 0 0 60 10 0 20 60 30 0 40 }
    key 30 { line 30 0 31 40 32 0 33 40 34 0 35 40 }
}
)";

}

TEST_CASE_TEMPLATE("the picture does not depend on the height of the bands", Format,
                   std::integral_constant<PixelFormat, PixelFormat::rgb565>,
                   std::integral_constant<PixelFormat, PixelFormat::grey4>,
                   std::integral_constant<PixelFormat, PixelFormat::mono1>)
{
    constexpr PixelFormat format = Format::value;
    for (const std::string_view text : {busy_scene, everything}) {
        PlayerFixture fixture{text, {60, 40}};
        for (const int frame : {0, 4, 13, 22, 27}) {
            const Bytes whole = fixture.picture<format>(Time::frame(frame));
            for (const int band_rows : {1, 3, 8, 39})
                CHECK(fixture.picture<format>(Time::frame(frame), band_rows) == whole);
        }
    }
}

TEST_CASE("the picture does not depend on what was shown before, nor on rows that were left undrawn")
{
    std::mt19937 random{31};
    for (const std::string_view text : {busy_scene, everything}) {
        PlayerFixture travelled{text, {60, 40}};
        for (int round = 0; round < 40; ++round) {
            const Time time{static_cast<std::int32_t>(random() % (30 * 1024))};
            travelled.player.show({static_cast<std::int32_t>(random())});
            Bytes few_rows(60 * 2 * 7);
            travelled.player.draw_rows<PixelFormat::rgb565>(7, few_rows);
            PlayerFixture fresh{travelled.bytes, {60, 40}};
            CHECK(travelled.picture(time) == fresh.picture(time));
        }
    }
}

TEST_CASE("no moment needs more memory for outlines, or more steps, than the scene says")
{
    std::mt19937 random{32};
    for (const std::string_view text : {busy_scene, everything})
        for (const Size panel : {Size{60, 40}, Size{7, 5}, Size{240, 240}}) {
            PlayerFixture fixture{text, panel};
            std::size_t max_bytes = 0;
            std::size_t max_steps = 0;
            for (int round = 0; round < rounds(3000); ++round) {
                fixture.player.show({static_cast<std::int32_t>(random())});
                const raster::Picture& picture = fixture.player.picture();
                CHECK(picture.coarseness == 0);
                max_bytes = std::max(max_bytes, picture.outlines.needed_bytes());
                max_steps = std::max(max_steps, picture.step_count);
            }
            if (panel.width <= 60) {
                CHECK(max_bytes <= fixture.scene.outline_bytes());
                CHECK(max_bytes > fixture.scene.outline_bytes() / 4); // the bound is not a guess far off
            }
            CHECK(max_steps == fixture.scene.paint_steps());
        }
}

TEST_CASE("a player writes to its block and to the rows it is asked for, nowhere else")
{
    constexpr std::size_t guard = 64;
    constexpr std::byte mark{0xA5};
    constexpr Size panel{61, 33};
    const Bytes bytes = compiled(everything);
    const SceneView scene = *SceneView::parse(bytes);
    const std::size_t size = Player::block_bytes(scene, panel);
    Bytes memory(size + 2 * guard, mark);
    auto player = Player::create(scene, panel, Fit::cover, std::span{memory}.subspan(guard, size));
    REQUIRE(player);
    const auto is_untouched = [](std::span<const std::byte> part) {
        return std::ranges::all_of(part, [](std::byte byte) { return byte == mark; });
    };
    const auto draw = [&]<PixelFormat format>(std::integral_constant<PixelFormat, format>) {
        const std::size_t picture = row_bytes(format, panel.width) * panel.height;
        Bytes pixels(picture + 2 * guard, mark);
        player->draw_rows<format>(panel.height, std::span{pixels}.subspan(guard, picture));
        CHECK(is_untouched(std::span{pixels}.first(guard)));
        CHECK(is_untouched(std::span{pixels}.last(guard)));
    };
    for (int frame = 0; frame < 30; ++frame) {
        player->show(Time::frame(frame));
        draw(std::integral_constant<PixelFormat, PixelFormat::rgb565>{});
        player->show(Time::frame(frame));
        draw(std::integral_constant<PixelFormat, PixelFormat::grey4>{});
        player->show(Time::frame(frame));
        draw(std::integral_constant<PixelFormat, PixelFormat::mono1>{});
        player->show(Time::frame(frame));
        draw(std::integral_constant<PixelFormat, PixelFormat::rgb444>{});
        player->show(Time::frame(frame));
        draw(std::integral_constant<PixelFormat, PixelFormat::rgb666>{});
    }
    CHECK(is_untouched(std::span{memory}.first(guard)));
    CHECK(is_untouched(std::span{memory}.last(guard)));
}

TEST_CASE("a block has room for outlines, a record, steps, and a tile for each level of blending")
{
    const auto block_bytes = [](const std::string& properties) {
        const Bytes bytes =
            compiled("kfast 1\ncanvas 9 9\ngroup " + properties +
                     " { group opacity=0.5 { object o fill=red stroke=blue { rect 0 0 9 9 } } }");
        const SceneView scene = *SceneView::parse(bytes);
        return Player::block_bytes(scene, {20, 10}) - PreparedScene::bytes_for(scene);
    };
    constexpr std::size_t tile_bytes = 512;
    constexpr std::size_t steps = 2 * 2; // to begin and to end blending, of two pictures
    CHECK(block_bytes("opacity=0.5") - block_bytes("opacity=1") ==
          steps * sizeof(raster::PaintStep) + tile_bytes);
}

TEST_CASE("a block that is one byte short is refused")
{
    const Bytes bytes = compiled(busy_scene);
    const SceneView scene = *SceneView::parse(bytes);
    Bytes block(Player::block_bytes(scene, {60, 40}) - 1);
    const auto player = Player::create(scene, {60, 40}, Fit::contain, block);
    REQUIRE(!player);
    CHECK(player.error() == Error::block_too_small);
}

TEST_CASE("on a key the drawing is the one that was drawn, whatever the neighbours have")
{
    PlayerFixture morphing{busy_scene, {60, 40}};
    PlayerFixture still{R"(
kfast 1
canvas 60 40 background="#203040" frames=30
object morph fill="#ff8000" stroke=white width=3 cap=round join=round {
    polygon 10 3 17 10 10 17 3 10; rect 30 20 20 15; line 5 35 55 35
}
object zigzag stroke="#00ff80" width=5 cap=square join=miter {
    key 0 { line 0 0 60 10 0 20 60 30 0 40 }
    key 30 { line 30 0 31 40 32 0 33 40 34 0 35 40 }
}
)",
                        {60, 40}};
    CHECK(morphing.picture(Time::frame(10)) == still.picture(Time::frame(10)));
}

TEST_CASE("a linear tween puts a box halfway, laws apart for x and y")
{
    constexpr std::string_view text = R"(
kfast 1
canvas 8 4 frames=8
object box fill=white {
    key 0 law-x=constant law-y=accelerate { rect 0 0 2 1 }
    key 8 { rect 4 3 2 1 }
}
)";
    PlayerFixture fixture{text, {8, 4}};
    const Bytes picture = fixture.picture<PixelFormat::grey4>(Time::frame(4));
    // y: 3 (1 - cos 45 degrees) = 0.879
    CHECK(row_text(picture) == "00220000"
                               "00dd0000"
                               "00000000"
                               "00000000");
}

TEST_CASE("loop modes wrap any time")
{
    const auto crc_at = [](std::string_view loop, int ticks) {
        PlayerFixture fixture{
            "kfast 1\ncanvas 16 8 frames=10 loop=" + std::string{loop} +
                "\nobject box fill=white { key 0 { rect 0 0 4 4 }; key 10 { rect 12 4 4 4 } }",
            {16, 8}};
        Crc32 crc;
        crc.add(fixture.picture({ticks}));
        return crc.value();
    };
    constexpr int length = 10 * 1024;
    CHECK(crc_at("repeat", length) == crc_at("repeat", 0));
    CHECK(crc_at("repeat", -1) == crc_at("repeat", length - 1));
    CHECK(crc_at("repeat", 7 * length + 300) == crc_at("repeat", 300));
    CHECK(crc_at("once", length) == crc_at("once", 5 * length));
    CHECK(crc_at("once", length) != crc_at("once", 0));
    CHECK(crc_at("once", -50) == crc_at("once", 0));
    CHECK(crc_at("ping-pong", length) == crc_at("once", length));
    CHECK(crc_at("ping-pong", length + 300) == crc_at("ping-pong", length - 300));
    CHECK(crc_at("ping-pong", 2 * length) == crc_at("ping-pong", 0));
    CHECK(crc_at("ping-pong", -300) == crc_at("ping-pong", 300));
}

TEST_CASE("a moment is not wrapped: the end of a scene that repeats can be shown")
{
    const auto text = [](const std::string& loop) {
        return "kfast 1\ncanvas 16 8 frames=10 loop=" + loop +
               "\nobject box fill=white { key 0 { rect 0 0 4 4 }; key 10 { rect 12 4 4 4 } }";
    };
    const auto moment = [&text](const std::string& loop, Time time) {
        PlayerFixture fixture{text(loop), {16, 8}};
        fixture.player.show_moment(time);
        Bytes pixels(16 * 8 * 2);
        fixture.player.draw_rows<PixelFormat::rgb565>(8, pixels);
        return pixels;
    };
    PlayerFixture once{text("once"), {16, 8}};
    const Bytes begin = once.picture({});
    const Bytes end = once.picture(Time::frame(10));
    REQUIRE(begin != end);
    PlayerFixture repeating{text("repeat"), {16, 8}};
    CHECK(repeating.picture(Time::frame(10)) == begin);
    for (const std::string loop : {"once", "repeat", "ping-pong"}) {
        CHECK(moment(loop, Time::frame(10)) == end);
        CHECK(moment(loop, Time::frame(13)) == end);
        CHECK(moment(loop, Time::frame(-3)) == begin);
        CHECK(moment(loop, Time::frame(4)) == once.picture(Time::frame(4)));
    }
}

TEST_CASE("the canvas is laid on panels of other shapes")
{
    constexpr std::string_view text = "kfast 1\ncanvas 4 2\nobject all fill=white { rect 0 0 4 2 }";
    SUBCASE("contain: whole, background above and below")
    {
        PlayerFixture fixture{text, {8, 8}, Fit::contain};
        CHECK(row_text(fixture.picture<PixelFormat::grey4>({})) ==
              std::string(16, '0') + std::string(32, 'f') + std::string(16, '0'));
    }
    SUBCASE("cover: no background left")
    {
        PlayerFixture fixture{text, {8, 8}, Fit::cover};
        CHECK(row_text(fixture.picture<PixelFormat::grey4>({})) == std::string(64, 'f'));
    }
    SUBCASE("none: pixel for pixel in the middle")
    {
        PlayerFixture fixture{text, {8, 4}, Fit::none};
        CHECK(row_text(fixture.picture<PixelFormat::grey4>({})) == "00000000"
                                                                   "00ffff00"
                                                                   "00ffff00"
                                                                   "00000000");
    }
}

TEST_CASE("colours become those of the format")
{
    constexpr std::string_view text = "kfast 1\ncanvas 2 1 background=\"#ff8000\"\n"
                                      "object half fill=\"#0080ff\" { rect 0.5 0 0.5 1 }";
    PlayerFixture fixture{text, {2, 1}};
    SUBCASE("rgb565, little-endian; half covered is half of each")
    {
        // ff8000 is 31, 32, 0; 0080ff is 0, 32, 31; half between them is 16, 32, 16
        constexpr int mixed = 16 << 11 | 32 << 5 | 16;
        constexpr int back = 31 << 11 | 32 << 5;
        CHECK(fixture.picture({}) == Bytes{std::byte{mixed & 255}, std::byte{mixed >> 8},
                                           std::byte{back & 255}, std::byte{back >> 8}});
    }
    SUBCASE("grey: 0.30 red, 0.59 green, 0.11 blue")
    {
        // ff8000: 152 -> 9; 0080ff: 104 -> 6; half: 128 -> 8
        CHECK(row_text(fixture.picture<PixelFormat::grey4>({})) == "89");
    }
    SUBCASE("one bit: the brighter half is lit, leftmost pixel in the highest bit")
    {
        CHECK(fixture.picture<PixelFormat::mono1>({}) == Bytes{std::byte{0b11000000}}); // 128 and 152 of 255
        PlayerFixture darker{"kfast 1\ncanvas 2 1 background=\"#ff8000\"\n"
                             "object half fill=\"#0070ff\" { rect 0.5 0 0.5 1 }",
                             {2, 1}};
        CHECK(darker.picture<PixelFormat::mono1>({}) == Bytes{std::byte{0b01000000}}); // 123 and 152
    }
}

TEST_CASE("later objects lie on earlier ones")
{
    PlayerFixture fixture{
        "kfast 1\ncanvas 3 1\nobject a fill=white { rect 0 0 2 1 }\nobject b fill=black { rect 1 0 2 1 }",
        {3, 1}};
    CHECK(row_text(fixture.picture<PixelFormat::grey4>({})) == "f000");
}

}
