#include "host/simulator/simulated_board.hpp"

#include "firmware/run.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

static_assert(WatchingBoard<SimulatedBoard>);

TEST_CASE("the simulated board says why a scene cannot be played")
{
    const auto text = bytes({'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                             'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                             'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.'});
    SimulatedBoard board{text};
    run(board);
    CHECK(board.error() == Error::bad_magic);
    CHECK(board.frames().empty());
}

TEST_CASE("a shown frame has its time, the hash of what was sent and the picture that it made")
{
    SimulatedBoard board{{}};
    board.panel().begin([](Microseconds) {});
    const std::vector<std::byte> pixels(128 * 64 / 2, std::byte{0x7C});
    board.watch(pixels);
    board.panel().start({.x = 0, .y = 0, .width = 128, .height = 64}, pixels);
    while (board.panel().busy()) {
    }
    board.frame_shown({.time = Time::frame(3), .skipped = 0});

    CHECK_FALSE(board.bus_error().has_value());
    REQUIRE(board.frames().size() == 1);
    const ShownFrame& frame = board.frames().front();
    CHECK(frame.time == Time::frame(3));
    CHECK(frame.hash == 0x7FE5'EB9F);
    CHECK(frame.picture.size() == 128 * 64);
    CHECK(frame.picture[0] == 7);
    CHECK(frame.picture[1] == 12);
}

}
