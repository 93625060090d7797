#include "host/fit/pico_target.hpp"

#include "firmware/controller_facts.hpp"

#include <doctest/doctest.h>

namespace kfast::fit {

TEST_CASE("a Pico has the display and the bus of its settings")
{
    for (std::size_t number = 0; number < controller_names.size(); ++number) {
        BoardSettings settings;
        settings.panel = controller_facts[number].usual;
        settings.panel.rotation = Rotation::quarter;
        settings.bus = kfast::BusKind::parallel_8;
        settings.bus_clock = 3'000'000;
        const Target target = pico_target(settings);
        CHECK(target.name == "pico");
        CHECK(target.display.name == controller_names[number]);
        CHECK(target.display.size == settings.panel.size());
        CHECK(target.bus.kind == BusKind::parallel_8);
        CHECK(target.bus.clock == 3e6);
    }
}

}
