#include "host/simulator/simulated_board.hpp"

#include "firmware/run/fault_card.hpp"
#include "firmware/run/run.hpp"
#include "tests/host/compiler/scene_parts.hpp"
#include "tests/host/simulator/wired_model.hpp"

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

using GreyBoard = SimulatedBoard<Ssd0323<SimulatedBus>>;

const PanelSettings& grey_panel = facts_of(Controller::ssd0323).default_value;

std::vector<ShownFrame> played(std::span<const std::byte> scene, std::size_t frames)
{
    GreyBoard board{scene, grey_panel, frames};
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

/// Drives an ST7735 that is turned by a quarter: the least that shows pictures.
class TurnedPanel {
public:
    static constexpr PixelFormat format = PixelFormat::rgb565;
    static constexpr Size granularity{1, 1};
    static constexpr int window_bytes = dcs_window_bytes;

    TurnedPanel(SimulatedBus& bus, const PanelSettings& settings) : bus_{bus}, settings_{settings} {}

    Size size() const { return settings_.size(); }

    template <class Pause>
    void begin(Pause&& pause)
    {
        send(0x11);
        pause(Microseconds{120'000});
        send(0x36, {0x68});
        send(0x3A, {0x05});
        send(0x29);
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        const Size memory = facts_of(Controller::st7735).memory;
        select(0x2A, settings_.row + area.x, area.width);
        select(0x2B, memory.width - settings_.column - settings_.glass.width + area.y, area.height);
        send(0x2C);
        bus_.start_words(pixels);
    }

    bool busy() { return bus_.busy(); }

private:
    void select(int axis, int first, int count)
    {
        const int last = first + count - 1;
        send(axis, {first >> 8, first & 255, last >> 8, last & 255});
    }

    void send(int command, std::initializer_list<int> parameters = {})
    {
        bus_.command(bytes({command}));
        bus_.parameters(bytes(parameters));
    }

    SimulatedBus& bus_;
    PanelSettings settings_;
};

}

static_assert(EventBoard<GreyBoard>);

TEST_CASE("the simulated board says why a scene cannot be played")
{
    const auto text = bytes({'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                             'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                             'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.'});
    GreyBoard board{text, grey_panel, 1};
    run(board);
    CHECK(board.error() == Error::bad_magic);
    CHECK(board.frames().empty());
}

TEST_CASE("the panel shows what is wrong")
{
    const auto text = bytes({'n', 'o', ' ', 's', 'c', 'e', 'n', 'e'});
    GreyBoard board{text, grey_panel, 1};
    run(board);
    CHECK(board.error() == Error::bad_magic);
    CHECK_FALSE(board.bus_error().has_value());
    const FaultCard card{Error::bad_magic, {128, 64}};
    std::vector<std::byte> expected(128 / 2 * 64);
    for (int y = 0; y < 64; ++y)
        card.draw_row(PixelRow<PixelFormat::grey4>{expected.data() + 64 * y, 0, y});
    CHECK(board.picture().pixels == expected);
}

TEST_CASE("a shown frame has its time, the events before it and the picture on the glass")
{
    GreyBoard board{{}, grey_panel, 1};
    board.panel().begin([](Microseconds) {});
    const std::vector<std::byte> pixels(128 * 64 / 2, std::byte{0x7C});
    board.panel().start({.x = 0, .y = 0, .width = 128, .height = 64}, pixels);
    while (board.panel().busy()) {
    }
    CHECK(board.picture().pixels == std::vector<std::byte>(128 * 64 / 2));
    board.panel().light();
    board.event_passed({"step", Time::frame(3)});
    board.frame_shown({.time = Time::frame(3), .skipped = 0});

    CHECK_FALSE(board.bus_error().has_value());
    REQUIRE(board.frames().size() == 1);
    const ShownFrame& frame = board.frames().front();
    CHECK(frame.time == Time::frame(3));
    CHECK(frame.events == std::vector<std::string>{"step"});
    CHECK(frame.picture.size == Size{128, 64});
    CHECK(frame.picture.pixels == pixels);
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
    CHECK(frames[0].picture.pixels == std::vector<std::byte>(128 * 64 / 2, std::byte{0x99}));
}

TEST_CASE("a board with a turned panel of colours, on a bus of words, shows the scene upright")
{
    PanelSettings settings = facts_of(Controller::st7735).default_value;
    settings.rotation = Rotation::quarter;
    const auto scene = empty_scene(Time::frame(1), Loop::repeat);
    SimulatedBoard<TurnedPanel> board{scene, settings, 2};
    run(board);
    CHECK_FALSE(board.error().has_value());
    CHECK(board.bus_error().value_or("none") == "none");
    REQUIRE(board.frames().size() == 2);
    const Frame& picture = board.frames().front().picture;
    CHECK(picture.size == Size{160, 128});
    CHECK(pixels_of<PixelFormat::rgb565>(picture) == std::vector<int>(160 * 128, 0x9CD3));
}

TEST_CASE("an SSD1351 of 128x96 shows the scene all over the glass, however it is turned")
{
    const auto scene = empty_scene(Time::frame(1), Loop::repeat);
    for (const Rotation rotation :
         {Rotation::none, Rotation::quarter, Rotation::half, Rotation::three_quarters}) {
        PanelSettings settings = facts_of(Controller::ssd1351).default_value;
        settings.glass = {128, 96};
        settings.rotation = rotation;
        SimulatedBoard<Ssd1351<SimulatedBus>> board{scene, settings, 1};
        run(board);
        CHECK(board.bus_error().value_or("none") == "none");
        REQUIRE(board.frames().size() == 1);
        CHECK(board.picture().size == settings.size());
        const auto at = [&](int x, int y) {
            return pixel_of<PixelFormat::rgb565>(board.picture(), x, y) == 0x9CD3;
        };
        const Size size = settings.size();
        // The scene of 128 x 64 lies in the middle.
        const int above = (size.height - size.width / 2) / 2;
        CHECK(at(0, above));
        CHECK(at(size.width - 1, size.height - 1 - above));
    }
}

TEST_CASE("the board lets time pass in pauses, which the model sees")
{
    SimulatedBoard<TurnedPanel> board{{}, facts_of(Controller::st7735).default_value, 1};
    board.panel().begin([](Microseconds) {});
    CHECK(board.bus_error() == "byte 1 at 120.000 ms: command 0x36 too soon after reset or sleep");
}

}
