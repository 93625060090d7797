#include "host/fit/board_choice.hpp"

#include "firmware/settings/controller_facts.hpp"

#include <doctest/doctest.h>

namespace kfast::fit {

TEST_CASE("a Pico has the display and the bus of its settings")
{
    for (std::size_t number = 0; number < controller_names.size(); ++number) {
        BoardSettings settings;
        settings.panel = controller_facts[number].default_value;
        settings.panel.rotation = Rotation::quarter;
        settings.bus = kfast::BusKind::parallel_8;
        settings.bus_clock = 3'000'000;
        const Target target = pico_target(settings);
        CHECK(target.name == "pico");
        CHECK(target.display.name == controller_names[number]);
        CHECK(target.display.size == settings.panel.size());
        CHECK(target.bus.kind == BusKind::parallel_8);
        CHECK(target.bus.clock == 3e6);
        CHECK(target.watchdog == 8.3);
    }
}

TEST_CASE("a Pico with a vector display has the beam of its settings")
{
    BoardSettings settings;
    settings.bus = kfast::BusKind::dac;
    settings.bus_clock = 10'000'000;
    settings.beam = galvo_profile;
    settings.beam.rate = 20'000;
    const Target target = pico_target(settings);
    CHECK(target.name == "pico-xy");
    CHECK(target.beam == settings.beam);
    CHECK(target.bus.kind == BusKind::dac);
    CHECK(target.bus.clock == 1e7);
    CHECK(target.watchdog == 8.3);
}

}
