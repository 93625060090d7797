#include "core/player.hpp"

#include "core/bytes/op_counter.hpp"
#include "host/compiler/write/header.hpp"
#include "tests/core/everything.hpp"
#include "tests/core/panel_memory.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/rounds.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <doctest/doctest.h>
#include <random>
#include <string>

/// What is kept from picture to picture: contours of drawings that move as a whole, and drawings between two
/// keys.
namespace kfast::test {
namespace {

constexpr std::string_view mover = R"scene(
kfast 1
canvas 60 40 frames=30
bones arm {
    bone upper 10 10 30 10 { bone lower 30 10 50 10 }
    pose 0 { upper turn=0; lower turn=0 }
    pose 30 { upper turn=120; lower turn=-200 }
}
object upper fill=red stroke=white width=2 join=round skin=arm bone=upper { path "M 8 8 C 15 0 25 0 32 8 L 32 12 L 8 12 Z" }
object lower stroke=yellow width=3 cap=round skin=arm bone=lower { path "M 30 10 C 35 5 45 15 50 10" }
group scale=0.5 { object star fill=blue rule=even-odd { polygon 30 5 36 25 20 12 40 12 24 25 }; key 0 rotate=0; key 30 rotate=360 }
object growing fill=green stroke=black width=1 { circle 45 30 r=4; key 0 scale=0.2; key 30 scale=5 }
object squashed fill=white { circle 15 30 r=6; key 0 scale-x=1; key 30 scale-x=0.2 }
object held fill=silver { key 0 law=hold { rect 2 2 5 5 }; key 15 { rect 3 3 5 5 }; key 20 { rect 8 3 9 5 } }
)scene";

/// Drawings between two keys in all ways: strokes that break, lines beside curves, an empty drawing, closed
/// beside open, held, swinging beyond both keys, by backbones, in space, squashed.
constexpr std::string_view shifter = R"scene(
kfast 1
canvas 60 40 frames=30
object splits fill=red stroke=white width=1 { key 0 law="bezier(0.3,-0.4,0.7,1.5)" { circle 12 10 r=8 }; key 10 { rect 2 2 8 8; rect 14 4 8 8; path "M 30 2 C 34 2 34 8 30 8" }; key 20 { empty }; key 29 { line 2 2 20 20 } }
object opens stroke=yellow width=2 join=round { key 0 { path "M 30 30 L 40 30 L 35 38 Z" }; key 12 { path "M 28 28 L 42 30 C 44 32 36 36 32 38" } }
object held fill=silver { key 0 law=hold { rect 2 30 5 5 }; key 15 law=hold { circle 8 32 r=4; circle 14 32 r=2 }; key 20 { rect 8 30 9 5 } }
object squashed fill=green { key 0 scale-x=0.5 { regular 50 10 r=8 sides=5 }; key 29 scale-x=2 { star 50 10 r=8 inner=3 points=5 } }
object deep fill=blue { key 0 rotate-y=0 { rect 40 20 12 12 }; key 29 rotate-y=70 { circle 46 26 r=6 } }
)scene";

Bytes with_cache_bytes(std::string_view text, std::uint32_t bytes)
{
    Bytes file = compiled(text);
    const SceneView scene = *SceneView::parse(file);
    set_outline_needs(file,
                      {.bytes = scene.outline_bytes(), .borders = scene.borders(), .cache_bytes = bytes});
    return file;
}

/// How often something is done to show a frame.
std::uint32_t done_at(PlayerFixture& fixture, int frame, Op op)
{
    class Counter : public OpCounter {
    public:
        std::uint32_t* counts_for(std::uint32_t) override { return all.data(); }

        std::array<std::uint32_t, op_kinds> all{};
    } counter;
    counter.counts = counter.all.data();
    op_counter = &counter;
    fixture.player.show_moment(Time::frame(frame));
    op_counter = nullptr;
    return counter.all[static_cast<std::size_t>(op)];
}

TEST_CASE("how much room the cache has does not change a picture")
{
    for (const std::string_view text : {mover, shifter, everything}) {
        PlayerFixture none{with_cache_bytes(text, 0), {60, 40}};
        for (const std::uint32_t bytes : {4U, 100U, 300U, 700U, 4000U}) {
            std::mt19937 random{bytes};
            PlayerFixture some{with_cache_bytes(text, bytes), {60, 40}};
            PanelMemory<PixelFormat::rgb565> memory{{60, 40}};
            for (int round = 0; round < rounds(120); ++round) {
                const Time moment{
                    static_cast<std::int32_t>(random() % 2 == 0 ? random() % 30 * 1024 : random() % 30'720)};
                some.player.show_moment(moment);
                bring_up_to_date(some, memory, 5);
                REQUIRE(memory.bytes() == none.picture(moment));
            }
        }
    }
}

TEST_CASE("nor does it on panels of other sizes")
{
    for (const Size panel : {Size{30, 20}, Size{100, 90}, Size{240, 160}}) {
        PlayerFixture none{with_cache_bytes(mover, 0), panel};
        PlayerFixture some{compiled(mover), panel};
        for (int frame = 0; frame < rounds(30); ++frame)
            REQUIRE(some.picture(Time::frame(frame)) == none.picture(Time::frame(frame)));
    }
}

TEST_CASE("the compiler leaves room for contours of what moves as a whole, and for drawings between two keys")
{
    const auto cache_bytes = [](const std::string& items) {
        return SceneView::parse(compiled("kfast 1\ncanvas 40 40 frames=10\n" + items))->cache_bytes();
    };
    const std::string shape = "rect 5 5 10 10";
    CHECK(cache_bytes("object o fill=red { " + shape + " }") == 0);
    CHECK(cache_bytes("object o fill=red { key 0 { " + shape + " }; key 9 { rect 6 6 9 9 } }") ==
          16 + 4 + 8 + 5 * 8);
    CHECK(cache_bytes("object o fill=red { " + shape + "; key 0 rotate=0; key 9 rotate=90 }") ==
          16 + 4 + 4 * 4);
    CHECK(cache_bytes("symbol s { object o fill=red { " + shape +
                      " } }\n"
                      "use s { key 0 x=0; key 9 x=9 }; use s { key 0 y=0; key 9 y=9 }") == 16 + 4 + 4 * 4);
}

TEST_CASE("contours that have room are not made anew in each picture")
{
    PlayerFixture fixture{compiled(mover), {60, 40}};
    fixture.player.show_moment(Time::frame(3));
    const std::size_t bytes = fixture.player.picture().cache.bytes_in_use();
    CHECK(bytes > 0);
    PlayerFixture without_room{with_cache_bytes(mover, 0), {60, 40}};
    CHECK(done_at(fixture, 4, Op::curve) < done_at(without_room, 4, Op::curve)); // squashed: in its place
    CHECK(fixture.player.picture().cache.bytes_in_use() == bytes);
}

TEST_CASE("drawings are read and made equal once between two keys, in any order of moments")
{
    const std::string text = "kfast 1\ncanvas 40 40 frames=31\nobject o fill=red { key 0 { circle 9 9 r=4 }; "
                             "key 10 { circle 20 9 r=8 }; key 20 { circle 20 20 r=5 } }";
    PlayerFixture fixture{compiled(text), {40, 40}};
    const auto reads_at = [&fixture](int frame) { return done_at(fixture, frame, Op::segment); };
    CHECK(reads_at(1) == 0); // they were for frame 0
    CHECK(reads_at(7) == 0);
    CHECK(reads_at(2) == 0);
    CHECK(reads_at(0) == 0); // on a key between drawings of the same make, too
    CHECK(reads_at(12) == 8);
    CHECK(reads_at(10) == 0);
    CHECK(reads_at(9) == 8);
    CHECK(reads_at(25) == 4);
    CHECK(reads_at(28) == 0);
    PlayerFixture without_room{with_cache_bytes(text, 0), {40, 40}};
    CHECK(done_at(without_room, 7, Op::segment) == 8);
    CHECK(done_at(without_room, 8, Op::segment) == 8);
}

}
}
