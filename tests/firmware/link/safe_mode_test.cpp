#include "firmware/run/notice_card.hpp"
#include "tests/firmware/link/playback_bench.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

/// Boards that their watchdog has restarted, seen through the link and on the display.
namespace kfast::test {

using namespace link;

namespace {

constexpr std::uint8_t hanging_slot = 2;

/// A board with a scene in a slot, which is chosen.
struct RestartedBench : PlaybackBench {
    explicit RestartedBench(const Restarts& restarts)
    {
        board.restarts = restarts;
        REQUIRE(put(board.slots, hanging_slot, "eyes", chosen) == Status::ok);
        REQUIRE(board.slots.choose(hanging_slot) == Status::ok);
    }

    bool plays(Home home)
    {
        const Playing now = playing();
        return now.is_playing && now.home == home;
    }

    bool shows_notice()
    {
        const RestartNotice notice{board.restarts};
        const NoticeCard card{notice.notice().title, notice.notice().words, small_panel};
        std::vector<std::byte> expected(small_panel.width * small_panel.height * 2);
        for (int y = 0; y < small_panel.height; ++y)
            card.draw_row(PixelRow<PixelFormat::rgb565>{
                expected.data() + static_cast<std::size_t>(y) * small_panel.width * 2, 0, y});
        return std::ranges::equal(board.panel().picture(), expected);
    }

    Scene chosen = padded_scene(3000, 1);
};

constexpr Restarts by_slot{.count = 2, .home = Home::slot, .slot = hanging_slot};
constexpr Restarts by_built_in{.count = 2, .home = Home::built_in};

}

TEST_CASE("after one restart the chosen slot plays, and the computer can know")
{
    RestartedBench bench{{.count = 1, .home = Home::slot, .slot = hanging_slot}};
    bench.board.run_for(300);
    CHECK(is_scene(bench.board.scene_begun(), bench.chosen));
    CHECK(bench.board.notices == 0);
    const Restarts told = bench.playing().restarts;
    CHECK(told.count == 1);
    CHECK(told.home == Home::slot);
    CHECK(told.slot == hanging_slot);
    CHECK(restarts_in(TestPlaybackBoard::kept)->slot == hanging_slot);
    CHECK(restarts_in(TestPlaybackBoard::kept)->count == 1);
}

TEST_CASE("in safe mode the display says why, and then the built-in scene plays instead of the chosen slot")
{
    RestartedBench bench{by_slot};
    bench.board.run_for(1000);
    CHECK(bench.board.notices == 1);
    CHECK(bench.shows_notice());
    CHECK(bench.playing().restarts.count == 2); // is answered meanwhile
    CHECK(bench.board.frames.empty());
    bench.board.run_for(5000);
    CHECK(is_scene(bench.board.scene_begun(), bench.board.built_in));
    CHECK(bench.plays(Home::built_in));
    CHECK(bench.ask<SlotContents>(AskSlot{hanging_slot}).is_chosen);
    CHECK(restarts_in(TestPlaybackBoard::kept)->home == Home::built_in);
    CHECK(restarts_in(TestPlaybackBoard::kept)->count == 2);
    bench.board.run_for(61'000);
    CHECK(restarts_in(TestPlaybackBoard::kept)->count == 0);
    CHECK(bench.playing().restarts.count == 2);
}

TEST_CASE("in safe mode nothing goes back to the chosen slot by itself")
{
    RestartedBench bench{by_slot};
    bench.board.run_for(6000);
    bench.does(Play{.home = Home::start});
    CHECK(bench.plays(Home::built_in));
    play_from_ram(bench, padded_scene(2000, 5));
    bench.does(Silence{.milliseconds = 100, .action = SilenceAction::start});
    bench.board.run_for(300);
    CHECK(bench.plays(Home::built_in));
    bench.does(Play{.home = Home::slot, .slot = hanging_slot});
    bench.board.run_for(100);
    CHECK(is_scene(bench.board.scene_begun(), bench.chosen));
}

TEST_CASE("in safe mode a choice is heeded")
{
    for (const std::uint8_t slot : {hanging_slot, std::uint8_t{4}}) {
        RestartedBench bench{by_slot};
        REQUIRE(put(bench.board.slots, 4, "other", padded_scene(2500, 7)) == Status::ok);
        bench.board.run_for(6000);
        bench.does(ChooseSlot{slot});
        CHECK(bench.plays(Home::built_in));
        bench.does(Play{.home = Home::start});
        CHECK(bench.playing().slot == slot);
    }
}

TEST_CASE("a built-in scene that hung is not played in safe mode, and the notice stays")
{
    for (const Home home : {Home::built_in, Home::start}) {
        RestartedBench bench{{.count = 2, .home = home}};
        bench.board.run_for(7000);
        CHECK_FALSE(bench.playing().is_playing);
        CHECK(bench.playing().restarts.home == home);
        CHECK(bench.shows_notice());
        CHECK(bench.board.scenes_begun == 0);
        CHECK(bench.board.faults.size() == 1);
        bench.does(Play{.home = Home::start});
        bench.board.run_for(100);
        CHECK_FALSE(bench.playing().is_playing);
        CHECK(bench.shows_notice());
    }
}

TEST_CASE("a board that plays nothing in safe mode plays what it is told to")
{
    RestartedBench bench{by_built_in};
    bench.board.run_for(7000);
    const Scene scene = padded_scene(2000, 9);
    play_from_ram(bench, scene);
    bench.board.run_for(100);
    CHECK(is_scene(bench.board.scene_begun(), scene));
    bench.does(Play{.home = Home::built_in});
    bench.board.run_for(100);
    CHECK(is_scene(bench.board.scene_begun(), bench.board.built_in));
    bench.does(ChooseSlot{no_slot});
    bench.does(Play{.home = Home::start});
    CHECK(bench.plays(Home::built_in));
}

TEST_CASE("a scene from RAM that hung does not bar the built-in one")
{
    RestartedBench bench{{.count = 2, .home = Home::ram}};
    bench.board.run_for(6000);
    CHECK(bench.plays(Home::built_in));
}

}
