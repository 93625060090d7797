#include "host/simulator/simulated_board.hpp"

#include "firmware/run.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace kfast::test {
namespace {

std::vector<std::byte> little_endian(std::uint32_t value)
{
    const auto byte = [value](int shift) { return static_cast<int>(value >> shift & 255); };
    return bytes({byte(0), byte(8), byte(16), byte(24)});
}

std::vector<std::byte> joined(std::initializer_list<std::vector<std::byte>> parts)
{
    std::vector<std::byte> result;
    for (const auto& part : parts)
        result.insert(result.end(), part.begin(), part.end());
    return result;
}

/// 30 fps, 128 x 64, no objects, on a grey ground of level 9.
std::vector<std::byte> empty_scene(Time length, Loop loop)
{
    const auto size_and_edges = joined({little_endian(36), little_endian(0)});
    const auto timing =
        joined({little_endian(static_cast<std::uint32_t>(length.ticks)), little_endian(30'000)});
    const auto counts = bytes({128, 0, 64, 0, 0, 0, 1, static_cast<int>(loop)});
    const auto checked = joined({size_and_edges, timing, counts, bytes({9 * 17, 9 * 17, 9 * 17, 0})});
    Crc32 checksum;
    checksum.add(checked);
    return joined({bytes({'K', 'F', 'B', 1}), little_endian(checksum.value()), checked});
}

std::vector<int> times_shown(Time length, Loop loop)
{
    const auto scene = empty_scene(length, loop);
    SimulatedBoard board{scene};
    run(board);
    CHECK_FALSE(board.error().has_value());
    CHECK_FALSE(board.bus_error().has_value());
    std::vector<int> times;
    for (const ShownFrame& frame : board.frames())
        times.push_back(frame.time.ticks);
    return times;
}

}

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

TEST_CASE("one pass of a scene is all frames before its end, and the end where it holds")
{
    CHECK(times_shown(Time::frame(3), Loop::repeat) == std::vector{0, 1024, 2048});
    CHECK(times_shown(Time::frame(3), Loop::ping_pong) == std::vector{0, 1024, 2048});
    CHECK(times_shown(Time::frame(3), Loop::once) == std::vector{0, 1024, 2048, 3072});
    CHECK(times_shown({1500}, Loop::repeat) == std::vector{0, 1024});
    CHECK(times_shown({1500}, Loop::once) == std::vector{0, 1024, 1500});
}

TEST_CASE("loop, player, driver and model together show the background of a scene")
{
    const auto scene = empty_scene(Time::frame(1), Loop::repeat);
    SimulatedBoard board{scene};
    run(board);
    REQUIRE(board.frames().size() == 1);
    CHECK(board.frames()[0].picture == std::vector<std::uint8_t>(128 * 64, 9));
    Crc32 hash;
    hash.add(std::vector<std::byte>(128 * 64 / 2, std::byte{0x99}));
    CHECK(board.frames()[0].hash == hash.value());
}

}
