#include "tests/firmware/link/link_bench.hpp"

#include <doctest/doctest.h>

/// Uploads, plays and sessions when the device has something else to do with its memory.
namespace kfast::test {

using namespace link;

TEST_CASE("a scene that came whole is not committed where its memory is needed for something else by then")
{
    LinkBench bench;
    const Scene scene = padded_scene(2000, 1);
    bench.ask<Begun>(LinkBench::begin_for_ram(scene), 42);
    bench.send_blocks(scene, 42);
    bench.last_failure();
    bench.device.leased = {};
    CHECK(bench.ask<Failure>(Commit{}, 42).status == Status::no_transfer);
    CHECK(bench.device.leases_ended == 1);
    CHECK(bench.refusal(Play{.home = Home::ram}) == StatusWithNumber{Status::nothing_in_ram});
}

TEST_CASE("a beginning that the device has put off is not meant for a new session")
{
    LinkBench bench;
    bench.device.puts_off = 1;
    bench.send(LinkBench::begin_for_ram(padded_scene(2000, 1)), 42);
    bench.link.begin_session();
    CHECK(bench.device.leases_ended == 1);
    bench.wait(1);
    CHECK_FALSE(bench.link.has_report());
    CHECK(bench.refusal(Cancel{}) == StatusWithNumber{Status::no_transfer});
}

TEST_CASE("a scene comes into a slot or into RAM, and nowhere else")
{
    LinkBench bench;
    for (const Home home : {Home::built_in, Home::here, Home::start})
        CHECK(bench.refusal(Begin{.home = home, .slot = 0, .size = 9}) ==
              StatusWithNumber{Status::bad_value});
}

TEST_CASE("the built-in scene plays at the start if that of the chosen slot is too large for the device")
{
    LinkBench bench;
    bench.device.built_in_scene = compiled("kfast 1\ncanvas 8 8\nobject dot fill=white { rect 1 1 2 2 }\n");
    const Scene scene = padded_scene(1000, 1);
    CHECK(bench.upload(LinkBench::begin_for_slot(3, "eyes", scene), scene, 42).is_ok());
    CHECK(bench.does(ChooseSlot{.slot = 3}));
    bench.device.largest_that_plays = bench.device.built_in_scene.size();
    CHECK(bench.does(Play{.home = Home::start}));
    CHECK(bench.device.selection.home == Home::built_in);
    bench.device.largest_that_plays = 1;
    CHECK(bench.refusal(Play{.home = Home::start}) == StatusWithNumber{Status::block_too_small});
}

}
