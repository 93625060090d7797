#include "tests/compiled.hpp"
#include "tests/firmware/link/playback_bench.hpp"

#include <doctest/doctest.h>

/// What plays on a board, seen through its link and on its display. TestPlaybackBoard checks every frame.
namespace kfast::test {

using namespace link;

namespace {

constexpr std::uint8_t tag = 42;

}

TEST_CASE("a board plays its built-in scene and tells so")
{
    PlaybackBench bench;
    bench.board.run_for(500);
    const Playing playing = bench.playing();
    CHECK(playing.is_playing);
    CHECK_FALSE(playing.is_paused);
    CHECK(playing.home == Home::built_in);
    CHECK(playing.slot == no_slot);
    CHECK(playing.brightness == 255);
    CHECK(playing.inputs == 2);
    CHECK(playing.canvas == Size{64, 48});
    CHECK(playing.length == Time::frame(60));
    CHECK(playing.speed == Playhead::as_authored);
    CHECK(playing.moment > Time{0});
    const auto capabilities = bench.ask<Capabilities>(Hello{});
    CHECK(capabilities.panel == small_panel);
    CHECK(capabilities.block_bytes == 40'000);
    CHECK(capabilities.ram_bytes == 20'000);
    CHECK(capabilities.serial.view() == "E6");
    CHECK(bench.ask<Names>(AskNames{}).board.view() == "board");
    CHECK(bench.board.panel().beginnings == 1);
}

TEST_CASE("a board answers while its panel begins")
{
    PlaybackBench bench;
    bench.send(AskPlaying{}, 1);
    bench.board.run_for(50);
    REQUIRE(bench.board.pipe.to_computer.size() == 1);
    CHECK(message_of<Playing>(bench.board.pipe.to_computer.front())->is_playing);
    CHECK(bench.board.frames.empty());
}

TEST_CASE("the chosen slot plays at the start, and the built-in scene if it cannot")
{
    const Scene scene = padded_scene(3000, 1);
    for (const bool is_damaged : {false, true}) {
        PlaybackBench bench;
        REQUIRE(put(bench.board.slots, 2, "eyes", scene) == Status::ok);
        REQUIRE(bench.board.slots.choose(2) == Status::ok);
        if (is_damaged)
            bench.board.flash.damage(small_places.pool + bench.board.slots.entry(2).offset + 50);
        bench.board.run_for(300);
        CHECK(bench.board.scenes_begun == 1);
        CHECK(is_scene(bench.board.scene_begun(), is_damaged ? bench.board.built_in : scene));
        CHECK(bench.playing().slot == (is_damaged ? no_slot : 2));
    }
}

TEST_CASE("a board without a scene shows a card, and can be talked to")
{
    PlaybackBench bench;
    bench.board.built_in.assign(2000, std::byte{0xFF});
    bench.board.run_for(300);
    CHECK(bench.board.faults == std::vector{Error::bad_magic});
    CHECK_FALSE(bench.playing().is_playing);
    CHECK(bench.refusal(AskInput{}) == StatusWithNumber{Status::nothing_plays});
    CHECK(bench.refusal(Play{.home = Home::built_in}) == StatusWithNumber{Status::no_scene});
    bench.does(Play{.home = Home::start});
    bench.board.run_for(100);
    CHECK_FALSE(bench.playing().is_playing);
    bench.does(Pause{});
    bench.does(Seek{});
    const Scene scene = padded_scene(2000, 1);
    play_from_ram(bench, scene);
    bench.board.run_for(50);
    CHECK(is_scene(bench.board.scene_begun(), scene));
    CHECK(bench.playing().home == Home::ram);
    bench.does(Silence{.milliseconds = 100, .action = SilenceAction::start});
    bench.board.run_for(200);
    CHECK(bench.board.faults.size() == 3);
}

TEST_CASE("a scene in RAM plays within a tenth of a second, on a panel that is not begun again")
{
    PlaybackBench bench;
    bench.board.built_in =
        compiled("kfast 1\ncanvas 8 8 fps=1 frames=60\nobject a fill=white { rect 1 1 4 4 }");
    bench.board.run_for(1500);
    const Scene scene = padded_scene(2048, 1);
    bench.upload(PlaybackBench::for_ram(scene), scene, tag);
    const Microseconds asked = bench.board.now();
    bench.does(Play{.home = Home::ram});
    bench.board.run_for(20);
    CHECK(is_scene(bench.board.scene_begun(), scene));
    CHECK((bench.board.begun_at - asked).count < 100'000);
    CHECK(bench.board.panel().beginnings == 1);
}

TEST_CASE("scenes in RAM follow one another, and the old one plays until the new one does")
{
    PlaybackBench bench;
    bench.board.run_for(300);
    for (std::uint32_t seed = 1; seed < 12; ++seed) {
        const Scene scene = padded_scene(1500 + seed * 177, seed);
        const int begun = bench.board.scenes_begun;
        const std::size_t frames = bench.board.frames.size();
        bench.upload(PlaybackBench::for_ram(scene), scene, static_cast<std::uint8_t>(seed));
        bench.board.run_for(100);
        CHECK(bench.board.frames.size() > frames);
        CHECK(bench.board.scenes_begun == begun);
        bench.does(Play{.home = Home::ram});
        bench.board.run_for(100);
        CHECK(is_scene(bench.board.scene_begun(), scene));
    }
}

TEST_CASE("a scene in RAM that plays stays when its upload is cancelled, and after a while")
{
    PlaybackBench bench;
    const Scene scene = padded_scene(2000, 1);
    play_from_ram(bench, scene);
    bench.does(Cancel{}, tag);
    bench.board.run_for(5'000);
    CHECK(bench.playing().home == Home::ram);
    CHECK(is_scene(bench.board.scene_begun(), scene));
    bench.does(Play{.home = Home::here});
    bench.board.run_for(100);
    CHECK(bench.playing().home == Home::ram);
}

TEST_CASE("playing from a slot goes on while the slot is replaced")
{
    PlaybackBench bench;
    bench.board.run_for(300);
    const Scene first = padded_scene(9000, 1);
    bench.upload(PlaybackBench::for_slot(1, first), first, tag);
    bench.does(Play{.home = Home::slot, .slot = 1});
    bench.board.run_for(100);
    bench.board.flash_time = Microseconds{5'000};
    for (std::uint32_t seed = 2; seed < 8; ++seed) {
        const Scene next = padded_scene(9000 + seed, seed);
        bench.upload(PlaybackBench::for_slot(1, next), next, static_cast<std::uint8_t>(seed));
        CHECK(is_scene(bench.board.scene_begun(), first));
    }
    CHECK(bench.ask<Statistics>(AskStatistics{}).late > 0);
    bench.does(Play{.home = Home::slot, .slot = 1});
    bench.board.run_for(100);
    CHECK(is_scene(bench.board.scene_begun(), padded_scene(9007, 7)));
}

}
