#include "host/simulator/simulated_bus.hpp"

#include "firmware/panel/panel_choice.hpp"
#include "tests/host/simulator/wired_model.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

static_assert(WordBus<SimulatedBus>);

struct Wired {
    PanelSettings settings = facts_of(Controller::ssd0323).default_value;
    std::unique_ptr<ControllerModel> model = make_controller_model(settings);
    SimulatedClock clock;
    SimulatedBus bus{*model, clock};
    Ssd0323<SimulatedBus> panel = make_panel<Ssd0323<SimulatedBus>>(bus, settings);

    void send(Rect area, std::span<const std::byte> pixels)
    {
        panel.start(area, pixels);
        while (panel.busy()) {
        }
    }
};

}

TEST_CASE("the SSD0323 driver draws on the model what it is given")
{
    Wired wired;
    wired.panel.begin([](Microseconds) {});
    wired.panel.light();
    std::vector<std::byte> whole(128 * 64 / 2);
    for (std::size_t i = 0; i < whole.size(); ++i)
        whole[i] = static_cast<std::byte>(i * 37 + i / 64);
    wired.send({.x = 0, .y = 0, .width = 128, .height = 64}, whole);
    const std::vector<std::byte> patch(3 * 5, std::byte{0x5A});
    wired.send({.x = 122, .y = 59, .width = 6, .height = 5}, patch);

    CHECK_FALSE(wired.model->error().has_value());
    CHECK_FALSE(wired.bus.error().has_value());
    for (std::size_t y = 59; y < 64; ++y)
        std::fill_n(whole.begin() + static_cast<std::ptrdiff_t>(y * 64 + 61), 3, std::byte{0x5A});
    CHECK(wired.model->picture().pixels == whole);
}

TEST_CASE("a buffer that is drawn into while it is sent spoils the picture")
{
    Wired wired;
    wired.panel.begin([](Microseconds) {});
    wired.panel.light();
    std::vector<std::byte> row(64, std::byte{0x11});
    wired.panel.start({.x = 0, .y = 0, .width = 128, .height = 1}, row);
    row.assign(64, std::byte{0x22});
    while (wired.panel.busy()) {
    }
    CHECK(wired.model->picture().pixels[63] == std::byte{0x22});
}

TEST_CASE("the bus notices whoever does not wait")
{
    Wired wired;
    const auto pixels = bytes({1, 2, 3, 4});
    wired.bus.start_data(pixels);
    SUBCASE("with a command")
    {
        wired.bus.command(pixels);
        CHECK(wired.bus.error() == "a command while data are on their way");
    }
    SUBCASE("with data")
    {
        wired.bus.start_data(pixels);
        CHECK(wired.bus.error() == "data while data are on their way");
    }
    SUBCASE("but not who does")
    {
        while (wired.bus.busy()) {
        }
        wired.bus.command(bytes({0xAE}));
        CHECK_FALSE(wired.bus.error().has_value());
    }
}

TEST_CASE("the bus sends words with the high byte first")
{
    WiredModel wired{with_glass(Controller::ssd1351, {2, 1})};
    wired.send(0xFD, {0xB1}).send(0xA0, {0x74}).send(0xCA, {127}).send(0xA2, {0}).low({0xAF});
    wired.send(0x15, {0, 1}).send(0x75, {0, 0}).low({0x5C});
    const SimulatedClock clock;
    SimulatedBus bus{*wired.model, clock};
    const auto words = bytes({0x34, 0x12, 0xCD, 0xAB});
    SUBCASE("all of them")
    {
        bus.start_words(words);
        while (bus.busy()) {
        }
        CHECK(wired.error() == "none");
        CHECK(pixels_of<PixelFormat::rgb565>(wired.model->picture()) == std::vector{0x1234, 0xABCD});
    }
    SUBCASE("in whole words only")
    {
        bus.start_words(std::span{words}.first(3));
        CHECK(bus.error() == "half a word");
    }
}

TEST_CASE("the bus tells the model what time it is")
{
    Wired wired;
    wired.clock.pass(Microseconds{1500});
    wired.clock.pass(Microseconds{0xFFFF'FFFF});
    wired.bus.command(bytes({0x23}));
    CHECK(wired.model->error() == "byte 0 at 4294968.795 ms: unknown command 0x23");
    CHECK(wired.clock.now() == Microseconds{1499});
}

}
