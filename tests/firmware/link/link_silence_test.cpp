#include "tests/firmware/link/link_bench.hpp"

#include <doctest/doctest.h>

/// What a device does when its computer falls silent, goes or comes anew.
namespace kfast::test {

using namespace link;

namespace {

constexpr std::uint8_t tag = 42;

}

TEST_CASE("when the computer falls silent that is done which it asked for, once")
{
    for (const auto action : {SilenceAction::hold, SilenceAction::start}) {
        LinkBench bench;
        CHECK(bench.does(Silence{.milliseconds = 200, .action = action}));
        const auto is_done = [&] {
            return action == SilenceAction::hold ? bench.device.now.is_paused
                                                 : bench.device.selection.home == Home::built_in &&
                                                       !bench.device.selection.scene.empty();
        };
        for (int report = 0; report < 5; ++report) {
            bench.wait(199);
            CHECK_FALSE(is_done());
            bench.link.take({}, bench.now);
        }
        bench.wait(200);
        CHECK(is_done());
        bench.device.resume();
        bench.device.stop();
        bench.wait(1000);
        bench.link.lose_computer();
        CHECK_FALSE(is_done());
    }
}

TEST_CASE("what is armed for silence is done at once when the computer goes, and not if it was disarmed")
{
    LinkBench bench;
    bench.link.lose_computer();
    CHECK(bench.does(Silence{.milliseconds = 60'000}));
    CHECK(bench.does(Silence{.milliseconds = 0}));
    bench.link.lose_computer();
    bench.wait(1000);
    CHECK_FALSE(bench.device.now.is_paused);
    CHECK(bench.does(Silence{.milliseconds = 60'000}));
    bench.link.begin_session();
    CHECK(bench.device.now.is_paused);
}

TEST_CASE("without any scene to return to the display says that nothing plays")
{
    LinkBench bench;
    bench.device.built_in_scene.assign(100, std::byte{0xFF});
    CHECK(bench.does(Silence{.milliseconds = 100, .action = SilenceAction::start}));
    bench.wait(100);
    CHECK(bench.device.says_that_nothing_plays);
}

TEST_CASE("a device that lies idle returns to the start")
{
    LinkBench bench;
    bench.device.is_left_alone = true;
    bench.wait(1);
    CHECK(bench.device.selection.home == Home::built_in);
    CHECK_FALSE(bench.device.selection.scene.empty());
}

TEST_CASE("a new session has nothing to do with the old one")
{
    LinkBench bench;
    const Scene scene = padded_scene(2000, 1);
    bench.ask<Begun>(LinkBench::begin_for_ram(scene), tag);
    bench.send_blocks(scene, tag);
    bench.send(AskPlaying{}, 5);
    CHECK(bench.link.has_report());
    bench.link.begin_session();
    CHECK_FALSE(bench.link.has_report());
    CHECK(bench.device.leases_ended == 1);
    CHECK(bench.refusal(Cancel{}) == StatusWithNumber{Status::no_transfer});
    CHECK(bench.ask<Failure>(Commit{}, tag).status == Status::no_transfer);
}

}
