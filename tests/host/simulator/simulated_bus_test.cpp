#include "host/simulator/simulated_bus.hpp"

#include "firmware/controller_facts.hpp"
#include "firmware/panel/ssd0323.hpp"
#include "host/simulator/ssd0323_model.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

struct Wired {
    Ssd0323Model model;
    SimulatedBus<Ssd0323Model> bus{model};
    Ssd0323<SimulatedBus<Ssd0323Model>> panel{bus, facts_of(Controller::ssd0323).usual};

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
    std::vector<std::byte> whole(128 * 64 / 2);
    for (std::size_t i = 0; i < whole.size(); ++i)
        whole[i] = static_cast<std::byte>(i * 37 + i / 64);
    wired.send({.x = 0, .y = 0, .width = 128, .height = 64}, whole);
    const std::vector<std::byte> patch(3 * 5, std::byte{0x5A});
    wired.send({.x = 122, .y = 59, .width = 6, .height = 5}, patch);

    CHECK_FALSE(wired.model.error().has_value());
    CHECK_FALSE(wired.bus.error().has_value());
    const auto picture = wired.model.picture();
    for (std::size_t y = 0; y < 64; ++y) {
        for (std::size_t x = 0; x < 128; ++x) {
            const auto byte = x >= 122 && y >= 59 ? std::byte{0x5A} : whole[y * 64 + x / 2];
            const auto expected = std::to_integer<int>(x % 2 == 0 ? byte >> 4 : byte & std::byte{15});
            if (picture[y * 128 + x] != expected)
                FAIL_CHECK("wrong at ", x, ", ", y);
        }
    }
}

TEST_CASE("a buffer that is drawn into while it is sent spoils the picture")
{
    Wired wired;
    wired.panel.begin([](Microseconds) {});
    std::vector<std::byte> row(64, std::byte{0x11});
    wired.panel.start({.x = 0, .y = 0, .width = 128, .height = 1}, row);
    row.assign(64, std::byte{0x22});
    while (wired.panel.busy()) {
    }
    CHECK(wired.model.picture()[127] == 2);
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

}
