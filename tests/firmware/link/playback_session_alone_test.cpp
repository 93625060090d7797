#include "firmware/link/playback_session.hpp"
#include "tests/core/raw_scene.hpp"
#include "tests/firmware/run/pretend_pins.hpp"
#include "tests/firmware/slots/slot_bench.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <optional>
#include <vector>

/// What a session answers that no run loop draws, or only as far as a test says.
namespace kfast::test {

using namespace link;

namespace {

constexpr Pin arm_pin = 3;

struct Bench {
    BoardSettings settings;
    Scene built_in = padded_scene(0, 0);
    std::vector<std::uint32_t> block = std::vector<std::uint32_t>(10'000);
    BoardFacts facts{.settings = settings, .panel_size = {64, 48}, .built_in = built_in};
    std::optional<PlaybackSession> playback;

    void start(std::size_t block_bytes)
    {
        facts.block = std::as_writable_bytes(std::span{block}).first(block_bytes);
        playback.emplace(facts);
    }
    void start() { start(4 * block.size()); }
    /// As a run loop that has come to draw.
    void draw()
    {
        REQUIRE(playback->begin());
        const auto scene = SceneView::parse(playback->scene_bytes());
        REQUIRE(scene);
        playback->scene_started(*scene);
    }
    Status play(const Scene& scene)
    {
        return playback->play({.scene = scene, .home = Home::slot, .slot = 2}, *SceneView::parse(scene));
    }
    std::size_t needed(const Scene& scene) const
    {
        return panel_player_bytes(*SceneView::parse(scene), facts);
    }
};

}

TEST_CASE("a board says what it cannot do")
{
    Bench bench;
    bench.start();
    CHECK(bench.playback->set_brightness(7) == Status::unsupported);
    CHECK(bench.playback->enter_boot_loader({}) == Status::unsupported);
    CHECK_FALSE(bench.playback->is_to_leave(Microseconds{0x7FFF'FFFF}));
    for (const Size& none : {Size{0, 48}, Size{64, 0}, Size{}}) {
        bench.facts.panel_size = none;
        bench.start();
        CHECK(bench.play(bench.built_in) == Status::unsupported);
    }
}

TEST_CASE("who is told to leave for the boot loader does so a tenth of a second later")
{
    Bench bench;
    bench.facts.has_boot_loader = true;
    bench.start();
    const Microseconds now{0xFFFF'FF00};
    REQUIRE(bench.playback->enter_boot_loader(now) == Status::ok);
    CHECK_FALSE(bench.playback->is_to_leave(now + Microseconds{99'999}));
    CHECK(bench.playback->is_to_leave(now + Microseconds{100'000}));
}

TEST_CASE("before there is a scene nothing is steered, and nothing takes texts and drawings")
{
    Bench bench;
    bench.start();
    bench.playback->pause();
    bench.playback->resume();
    bench.playback->set_speed(5);
    bench.playback->seek(Time{5});
    CHECK_FALSE(bench.playback->playing().is_playing);
    CHECK(bench.playback->playing().moment == Time{});
    CHECK(bench.playback->set_text(0, "a") == Status::nothing_plays);
    CHECK(bench.playback->deliver({.which = {}, .part = 0, .count = 0, .points = {}}) ==
          Status::nothing_plays);
}

TEST_CASE("a button arms a laser only where something has played")
{
    static bool is_armed;
    is_armed = false;
    Bench bench;
    bench.settings.controls[0] = {ControlKind::button, ControlAction::arm, arm_pin, {}};
    bench.facts.set_armed = [](bool armed) { is_armed = armed; };
    bench.start();
    PretendPins pins;
    Microseconds now{};
    const auto press = [&] {
        for (const bool is_down : {true, true, false, false}) {
            pins.closed[arm_pin] = is_down;
            now = now + Microseconds{50'000};
            bench.playback->watch_arming(pins, now);
        }
    };
    press();
    CHECK_FALSE(is_armed);
    bench.draw();
    press();
    CHECK(is_armed);
}

TEST_CASE("a scene that needs more than the block is refused, and what plays goes on")
{
    Bench bench;
    const Scene larger = compiled("kfast 1\ncanvas 64 48\nobject o fill=white {" + [] {
        std::string circles;
        for (int i = 0; i < 40; ++i)
            circles += " circle 10 " + std::to_string(4 + i % 30) + " r=5\n";
        return circles;
    }() + "}");
    REQUIRE(bench.needed(larger) > bench.needed(bench.built_in) + 100);
    bench.start((bench.needed(larger) - 4) / 4 * 4);
    bench.draw();
    CHECK(bench.play(larger) == Status::block_too_small);
    CHECK_FALSE(bench.playback->wants_to_begin());
    CHECK(bench.playback->playing().home == Home::built_in);
    CHECK(bench.playback->playing().is_playing);
}

TEST_CASE("what is to give way plays on if the memory is not wanted any more before the frame has ended")
{
    Bench bench;
    bench.start(bench.needed(bench.built_in) / 4 * 4 + 40);
    bench.draw();
    CHECK(bench.playback->lease_ram(2'000).empty());
    CHECK(bench.playback->is_changing());
    CHECK(bench.playback->lease_ram(2'000).empty()); // asked again too early
    CHECK(bench.playback->is_changing());
    bench.playback->end_lease();
    CHECK_FALSE(bench.playback->wants_to_begin());
    CHECK(bench.playback->playing().is_playing);
}

TEST_CASE("the end of a lease leaves the scene that is to play next")
{
    Bench bench;
    bench.start();
    bench.draw();
    REQUIRE_FALSE(bench.playback->lease_ram(2'000).empty());
    const Scene other = padded_scene(0, 1);
    CHECK(bench.play(other) == Status::ok);
    bench.playback->end_lease();
    CHECK(bench.playback->leased_ram().empty());
    bench.draw();
    CHECK(bench.playback->playing().slot == 2);
}

TEST_CASE("an input whose name begins with no letter at all has none that can be told")
{
    Bench bench;
    RawScene scene;
    scene.input_count = 1;
    scene.inputs = input_bytes(std::string(40, '\x80'));
    bench.built_in = scene.file();
    bench.facts.built_in = bench.built_in;
    bench.start();
    bench.draw();
    CHECK(bench.playback->input(0).name.view().empty());
}

}
