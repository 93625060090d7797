#include "library/kfast.h"
#include "library/kfast_player.hpp"

#include "tests/core/filling.hpp"
#include "tests/core/player_fixture.hpp"

#include <array>
#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

constexpr int width = 30;
constexpr int height = 20;

/// 25 frames per second: 40 ms each.
constexpr std::string_view moving = R"(
kfast 1
canvas 30 20 fps=25 frames=50
input size min=1 max=2 default=1
object dot fill=red { key 0 { rect 1 1 8 8 }; key 50 { rect 20 10 8 8 } }
group other { track x input=size { at 1 0; at 2 9 }; object dash fill=lime { rect 1 15 4 4 } }
clip there from=10 to=20 loop=once
clip between from=2.5 to=5.25 loop=once
event 0 begun
event 12 middle
)";

/// A player, what it is told and what its display shows.
class Sketch {
public:
    explicit Sketch(std::string_view text = moving) : scene_{compiled(text)}, display_(width * height)
    {
        REQUIRE(player.begin(scene_.data(), scene_.size(), width, height));
    }

    /// The events on the way, or "-" if there was nothing to draw either.
    std::string at(std::uint32_t milliseconds)
    {
        std::string events;
        const bool draws = player.update(milliseconds, [&events](KfastEvent event) {
            events += std::string{event.name, event.bytes} + " ";
        });
        const auto take = [this](int x, int y, int columns, int rows, const std::uint16_t* pixels) {
            for (int row = y; row < y + rows; ++row, pixels += columns)
                std::copy_n(pixels, columns, display_.begin() + row * width + x);
        };
        std::uint16_t buffer[3 * width];
        CHECK(player.draw(buffer, take));
        return draws ? events : events + "-";
    }

    bool shows(Time moment, Time size = {}) const
    {
        PlayerFixture fixture{scene_, {width, height}};
        fixture.player.set_input(0, size);
        return shows_picture(fixture, moment);
    }

    /// Whether it looks as the beginning of this scene.
    bool looks_like(std::string_view scene) const
    {
        PlayerFixture fixture{scene, {width, height}};
        return shows_picture(fixture, Time{});
    }

    KfastPlayer<20'000> player;

private:
    bool shows_picture(PlayerFixture& fixture, Time moment) const
    {
        const Bytes wanted = fixture.picture<PixelFormat::rgb565>(moment);
        return std::ranges::equal(wanted, std::as_bytes(std::span{display_}));
    }

    Bytes scene_;
    std::vector<std::uint16_t> display_;
};

}

TEST_CASE("a clock of milliseconds plays whole frames, from wherever it begins")
{
    for (const std::uint32_t start : {0u, 5u, 4'294'967'000u}) { // the last one runs over
        Sketch sketch;
        CHECK(sketch.at(start) == "begun ");
        CHECK(sketch.shows(Time{}));
        CHECK(sketch.at(start + 39) == "-");
        CHECK(sketch.shows(Time{}));
        CHECK(sketch.at(start + 40) == "");
        CHECK(sketch.shows(Time::frame(1)));
        CHECK(sketch.at(start + 79) == "-");
        CHECK(sketch.at(start + 500) == "middle ");
        CHECK(sketch.shows(Time::frame(12)));
        CHECK(sketch.at(start + 2000) == "begun ");
        CHECK(sketch.shows(Time{}));
    }
}

TEST_CASE("no part of a frame gets lost between updates")
{
    Sketch sketch{"kfast 1\ncanvas 30 20 fps=60 frames=600\n"
                  "object o fill=red { rect 1 1 8 8; key 0 x=0; key 599 x=20 }"};
    int frames = 0;
    for (std::uint32_t clock = 0; clock < 9990; clock += 3)
        frames += sketch.at(clock) != "-";
    CHECK(frames == 600);
}

TEST_CASE("a clip begins when it is next updated, and once finished shows its end")
{
    Sketch sketch;
    sketch.at(100);
    CHECK(sketch.player.play("there"));
    CHECK_FALSE(sketch.player.finished());
    CHECK(sketch.at(1000) == "");
    CHECK(sketch.shows(Time::frame(10)));
    CHECK(sketch.at(1399) == "middle ");
    CHECK_FALSE(sketch.player.finished());
    CHECK(sketch.at(5000) == "");
    CHECK(sketch.player.finished());
    CHECK(sketch.shows(Time::frame(20)));
    CHECK(sketch.at(6000) == "-");
    CHECK_FALSE(sketch.player.play("back"));
    CHECK(std::string_view{sketch.player.error()}.starts_with("no_such_clip"));
    CHECK(sketch.at(7000) == "-");
    CHECK(sketch.player.play());
    CHECK(sketch.at(9000) == "begun ");
    CHECK(sketch.shows(Time{}));
}

TEST_CASE("a clip that begins and ends between frames shows just that, and whole frames within")
{
    Sketch sketch;
    CHECK(sketch.player.play("between"));
    CHECK(sketch.at(0) == "");
    CHECK(sketch.shows({2 * 1024 + 512}));
    CHECK(sketch.at(19) == "-");
    CHECK(sketch.at(20) == "");
    CHECK(sketch.shows(Time::frame(3)));
    CHECK(sketch.at(110) == "");
    CHECK(sketch.player.finished());
    CHECK(sketch.shows({5 * 1024 + 256}));
}

TEST_CASE("what is set is drawn with the next update, between two frames as well")
{
    Sketch sketch;
    sketch.at(0);
    CHECK(sketch.player.set_input("size", 2000));
    CHECK(sketch.at(1) == "");
    CHECK(sketch.shows(Time{}, {65536}));
    CHECK(sketch.at(2) == "-");
    CHECK_FALSE(sketch.player.set_input("sise", 2000));
    CHECK_FALSE(sketch.player.set_text("size", "2"));
    CHECK(sketch.player.redraw());
    CHECK(sketch.at(3) == "");
    CHECK(std::string_view{sketch.player.error()} == "ok");
}

TEST_CASE("a drawing that is set is drawn with the next update")
{
    Sketch sketch{"kfast 1\ncanvas 30 20\ninput curve kind=drawing points=5 strokes=2 { line 1 1 9 9 }\n"
                  "object o stroke=lime live=curve"};
    sketch.at(0);
    const kfast_point points[] = {{16, 16}, {160, 32}, {24, 80}, {16, 240}, {320, 240}, {0, 0}};
    const std::uint16_t counts[] = {3, 2, 1};
    const auto shows_two_strokes = [&] {
        return sketch.looks_like("kfast 1\ncanvas 30 20\n"
                                 "object o stroke=lime { line 1 1 10 2 1.5 5; line 1 15 20 15 }");
    };
    CHECK(sketch.player.set_drawing("curve", points, counts, 2));
    CHECK(sketch.at(1) == "");
    CHECK(shows_two_strokes());
    CHECK_FALSE(sketch.player.set_drawing("curve", points, counts, 3));
    CHECK(std::string_view{sketch.player.error()}.starts_with("drawing_too_large"));
    CHECK_FALSE(sketch.player.set_drawing("curse", points, counts, 2));
    sketch.at(2);
    CHECK(shows_two_strokes());
    CHECK(sketch.player.set_drawing("curve", nullptr, nullptr, 0));
    sketch.at(3);
    CHECK(sketch.looks_like("kfast 1\ncanvas 30 20\nobject o stroke=lime { empty }"));
}

TEST_CASE("a player that could not begin draws nothing and says why")
{
    KfastPlayer<100> player;
    std::uint16_t buffer[width];
    const auto take = [](int, int, int, int, std::uint16_t*) { FAIL("drawn"); };
    CHECK_FALSE(player.update(0));
    CHECK_FALSE(player.play());
    CHECK_FALSE(player.set_drawing("curve", nullptr, nullptr, 0));
    CHECK_FALSE(player.finished());
    CHECK_FALSE(player.draw(buffer, take));
    CHECK(std::string_view{player.error()}.starts_with("null_pointer"));
    const Bytes scene = compiled(moving);
    CHECK_FALSE(player.begin(scene.data(), scene.size(), width, height));
    CHECK(std::string_view{player.error()}.starts_with("block_too_small"));
    CHECK_FALSE(player.update(0));
    CHECK_FALSE(player.draw(buffer, take));
}

TEST_CASE("a buffer without room for a row is refused")
{
    Sketch sketch;
    std::uint16_t buffer[width - 1];
    CHECK_FALSE(sketch.player.draw(buffer, [](int, int, int, int, std::uint16_t*) { FAIL("drawn"); }));
    CHECK(std::string_view{sketch.player.error()}.starts_with("buffer_too_small"));
}

TEST_CASE("other formats are drawn by their functions")
{
    Sketch sketch;
    std::uint8_t buffer[4];
    int pixels = 0;
    CHECK(sketch.player.draw<kfast_draw_mono1>(
        buffer,
        [&pixels](int, int, int columns, int rows, const std::uint8_t*) { pixels += columns * rows; }));
    CHECK(pixels == width * height);
}

TEST_CASE("the name of an event is compared as a whole")
{
    const KfastEvent event{"blinked", 5};
    CHECK(event == "blink");
    CHECK(event != "blin");
    CHECK(event != "blinked");
    CHECK(event != "black");
    CHECK(event != "");
}

}
