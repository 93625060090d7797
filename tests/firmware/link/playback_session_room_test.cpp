#include "tests/compiled.hpp"
#include "tests/firmware/link/playback_bench.hpp"

#include <array>
#include <doctest/doctest.h>
#include <functional>
#include <string>

/// What plays and what is sent share the block of a board. TestPlaybackBoard checks every frame.
namespace kfast::test {

using namespace link;

namespace {

constexpr std::uint8_t tag = 42;

/// A block in which one scene finds room, with its player, and not two.
struct TightBench : PlaybackBench {
    Scene first = padded_scene(4000, 1);
    Scene second = padded_scene(4000, 2);

    TightBench() : PlaybackBench{{}, (needed(padded_scene(4000, 1)) + 7000) / 4 * 4} {}

    std::size_t frames() const { return board.frames.size(); }
    /// Whether frames are drawn.
    bool plays()
    {
        const std::size_t before = frames();
        board.run_for(200);
        return frames() > before + 2;
    }
};

}

TEST_CASE("what plays from RAM gives way to another scene, and the picture holds meanwhile")
{
    TightBench bench;
    play_from_ram(bench, bench.first);
    CHECK(bench.plays());
    bench.begin(PlaybackBench::for_ram(bench.second), 43);
    CHECK_FALSE(bench.plays());
    CHECK_FALSE(bench.playing().is_playing);
    bench.send_blocks(bench.second, 43);
    bench.does(Commit{}, 43);
    bench.does(Play{.home = Home::ram});
    CHECK(bench.plays());
    CHECK(is_scene(bench.board.scene_begun(), bench.second));
}

TEST_CASE("when nothing comes of it the scene of the start plays")
{
    for (const bool is_cancelled : {false, true}) {
        TightBench bench;
        play_from_ram(bench, bench.first);
        bench.begin(PlaybackBench::for_ram(bench.second), 43);
        CHECK_FALSE(bench.plays());
        if (is_cancelled)
            bench.does(Cancel{}, 43);
        else
            bench.board.run_for(3100);
        CHECK(bench.plays());
        CHECK(bench.playing().home == Home::built_in);
    }
}

// The small scenes below play like those in flash, so that with their own bytes they need more than is lent.

TEST_CASE("a scene from flash that needs all memory gives way, and plays again if nothing comes of it")
{
    const Scene scene = padded_scene(4000, 1);
    for (const bool is_unplugged : {false, true}) {
        PlaybackBench bench{{}, (needed(scene) + 1000) / 4 * 4};
        REQUIRE(put(bench.board.slots, 5, "eyes", scene) == Status::ok);
        bench.does(Play{.home = Home::slot, .slot = 5});
        bench.board.run_for(100);
        const Scene small = padded_scene(1024, 4);
        bench.begin(PlaybackBench::for_ram(small), tag);
        bench.board.run_for(100);
        CHECK_FALSE(bench.playing().is_playing);
        if (is_unplugged) {
            bench.board.pipe.plug_in();
        } else { // which is accepted, but needs more than is left
            bench.send_blocks(small, tag);
            bench.does(Commit{}, tag);
            CHECK(bench.refusal(Play{.home = Home::ram}) == StatusWithNumber{Status::block_too_small});
        }
        bench.board.run_for(100);
        CHECK(bench.playing().slot == 5);
        CHECK(is_scene(bench.board.scene_begun(), scene));
    }
}

TEST_CASE("what gave way to a scene in RAM that nobody plays, plays again")
{
    const Scene scene = padded_scene(4000, 1);
    const std::array<std::function<void(PlaybackBench&)>, 4> ways{
        [](PlaybackBench& bench) { bench.does(Cancel{}, tag); },
        [](PlaybackBench& bench) { bench.board.pipe.plug_in(); },
        [](PlaybackBench& bench) { bench.board.run_for(4'000); },
        [](PlaybackBench& bench) {
            CHECK(bench.refusal(Play{.home = Home::ram, .clip = {"none"}}) ==
                  StatusWithNumber{Status::no_such_clip});
            bench.does(Cancel{}, tag);
        },
    };
    for (const auto& go_away : ways) {
        PlaybackBench bench{{}, (needed(scene) + 1000) / 4 * 4};
        REQUIRE(put(bench.board.slots, 5, "eyes", scene) == Status::ok);
        bench.does(Play{.home = Home::slot, .slot = 5});
        bench.board.run_for(100);
        const Scene small = padded_scene(1024, 4);
        bench.upload(PlaybackBench::for_ram(small), small, tag);
        bench.board.run_for(1'000);
        CHECK_FALSE(bench.playing().is_playing);
        go_away(bench);
        bench.board.run_for(100);
        CHECK(bench.playing().slot == 5);
        CHECK(is_scene(bench.board.scene_begun(), scene));
    }
}

TEST_CASE("a scene from flash that gave way is not written over, whatever becomes of its slot")
{
    const Scene scene = padded_scene(4000, 1);
    PlaybackBench bench{{}, (needed(scene) + 1000) / 4 * 4};
    REQUIRE(put(bench.board.slots, 5, "eyes", scene) == Status::ok);
    REQUIRE(put(bench.board.slots, 0, "all the rest", padded_scene((pool_sectors - 1) * sector_bytes, 2)) ==
            Status::ok);
    bench.does(Play{.home = Home::slot, .slot = 5});
    bench.board.run_for(300);
    bench.begin(PlaybackBench::for_ram(padded_scene(1024, 4)), tag);
    bench.does(EraseSlot{.slot = 5});
    CHECK(bench.refusal(PlaybackBench::for_slot(1, scene), 43) == StatusWithNumber{Status::no_room, 0});
    bench.board.run_for(200);
    CHECK(bench.playing().slot == 5);
}

TEST_CASE("a scene from flash has the whole block, whatever lies in RAM")
{
    const Scene large = compiled("kfast 1\ncanvas 64 48 frames=60\nobject sun fill=yellow {" + [] {
        std::string circles;
        for (int i = 0; i < 40; ++i)
            circles += " circle 10 " + std::to_string(4 + i % 30) + " r=5\n";
        return circles;
    }() + "}");
    const std::size_t block = (needed(large) + 3) / 4 * 4;
    PlaybackBench bench{{}, block};
    bench.board.run_for(300);
    REQUIRE(put(bench.board.slots, 0, "large", large) == Status::ok);
    const Scene small = padded_scene(2000, 1);
    REQUIRE(needed(small) + 2000 < block);
    bench.upload(PlaybackBench::for_ram(small), small, tag);
    bench.does(Play{.home = Home::slot, .slot = 0});
    bench.board.run_for(100);
    CHECK(is_scene(bench.board.scene_begun(), large));
    CHECK(bench.refusal(Play{.home = Home::ram}) == StatusWithNumber{Status::nothing_in_ram});
    CHECK(bench.playing().slot == 0);
}

}
