#include "host/simulator/simulated_board.hpp"

#include "firmware/run.hpp"
#include "tests/bytes.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kfast::test {
namespace {

/// 30 fps, 128 x 64, nothing but a grey ground of level 9, and events.
std::vector<std::byte> empty_scene(Time length, Loop loop, std::vector<scene::Event> events = {})
{
    constexpr std::uint8_t grey = 9 * 17;
    scene::Scene scene;
    scene.canvas = {128, 64};
    scene.length = length;
    scene.loop = loop;
    scene.palette = {{grey, grey, grey}};
    scene.events = std::move(events);
    return written(scene);
}

std::vector<ShownFrame> played(std::span<const std::byte> scene, std::size_t frames)
{
    SimulatedBoard board{scene, frames};
    run(board);
    CHECK_FALSE(board.error().has_value());
    CHECK_FALSE(board.bus_error().has_value());
    return board.frames();
}

std::vector<int> times_shown(Time length, Loop loop, std::size_t frames)
{
    std::vector<int> times;
    for (const ShownFrame& frame : played(empty_scene(length, loop), frames))
        times.push_back(frame.time.ticks);
    return times;
}

}

static_assert(WatchingBoard<SimulatedBoard>);
static_assert(EventBoard<SimulatedBoard>);

TEST_CASE("the simulated board says why a scene cannot be played")
{
    const auto text = bytes({'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                             'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                             'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.'});
    SimulatedBoard board{text, 1};
    run(board);
    CHECK(board.error() == Error::bad_magic);
    CHECK(board.frames().empty());
}

TEST_CASE("the panel shows the number of what is wrong")
{
    const auto text = bytes({'n', 'o', ' ', 's', 'c', 'e', 'n', 'e'});
    SimulatedBoard board{text, 1};
    run(board);
    CHECK(board.error() == Error::bad_magic);
    CHECK_FALSE(board.bus_error().has_value());
    const auto picture = board.picture();
    std::string blocks; // of 9 x 9 pixels, from (32, 9) on
    for (int line = 0; line < 5; ++line, blocks += '\n')
        for (int column = 0; column < 7; ++column)
            blocks +=
                picture[static_cast<std::size_t>((13 + 9 * line) * 128 + 36 + 9 * column)] == 15 ? '#' : '.';
    CHECK(blocks == "###.###\n"
                    "#.....#\n"
                    "###.###\n"
                    "#...#..\n"
                    "###.###\n");
}

TEST_CASE("a shown frame has its time, the hash of what was sent and the picture that it made")
{
    SimulatedBoard board{{}, 1};
    board.panel().begin([](Microseconds) {});
    const std::vector<std::byte> pixels(128 * 64 / 2, std::byte{0x7C});
    const Rect whole{.x = 0, .y = 0, .width = 128, .height = 64};
    board.watch(whole, pixels);
    board.panel().start(whole, pixels);
    while (board.panel().busy()) {
    }
    board.event_passed({"step", Time::frame(3)});
    board.frame_shown({.time = Time::frame(3), .skipped = 0});

    CHECK_FALSE(board.bus_error().has_value());
    REQUIRE(board.frames().size() == 1);
    const ShownFrame& frame = board.frames().front();
    CHECK(frame.time == Time::frame(3));
    CHECK(frame.events == std::vector<std::string>{"step"});
    CHECK(frame.hash == 0x7FE5'EB9F);
    CHECK(frame.picture.size() == 128 * 64);
    CHECK(frame.picture[0] == 7);
    CHECK(frame.picture[1] == 12);
}

TEST_CASE("the board plays a scene by its loop mode, as many frames as it is told")
{
    CHECK(times_shown(Time::frame(2), Loop::repeat, 4) == std::vector{0, 1024, 0, 1024});
    CHECK(times_shown(Time::frame(2), Loop::ping_pong, 4) == std::vector{0, 1024, 2048, 1024});
    CHECK(times_shown({1500}, Loop::once, 4) == std::vector{0, 1024, 1500, 1500});
}

TEST_CASE("the board tells the events with the frame that they come before")
{
    const auto scene = empty_scene(Time::frame(2), Loop::repeat,
                                   {{"a", Time{0}}, {"b", Time{1}}, {"c", Time{1024}}, {"d", Time{1025}}});
    std::vector<std::vector<std::string>> events;
    for (const ShownFrame& frame : played(scene, 4))
        events.push_back(frame.events);
    CHECK(events == std::vector<std::vector<std::string>>{{"a"}, {"b", "c"}, {"d", "a"}, {"b", "c"}});
}

TEST_CASE("loop, player, driver and model together show the background of a scene")
{
    const auto scene = empty_scene(Time::frame(1), Loop::repeat);
    const std::vector<ShownFrame> frames = played(scene, 1);
    REQUIRE(frames.size() == 1);
    CHECK(frames[0].picture == std::vector<std::uint8_t>(128 * 64, 9));
    Crc32 hash;
    hash.add(std::vector<std::byte>(128 * 64 / 2, std::byte{0x99}));
    CHECK(frames[0].hash == hash.value());
}

}
