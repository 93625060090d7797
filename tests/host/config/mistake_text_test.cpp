#include "host/config/mistake_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// What a record may hold, though no text can say it.
std::string said_of(const BoardSettings& settings)
{
    std::string all;
    for (const SettingsMistake& mistake : config::mistakes(settings)) {
        const config::Finding finding = config::text_of(mistake, settings);
        all += finding.message + ": " + finding.hint + '\n';
    }
    return all;
}

BoardSettings right_ones()
{
    BoardSettings settings;
    settings.bus_clock = 10'000'000;
    settings.pin(PinRole::clock) = 18;
    settings.pin(PinRole::data) = 19;
    settings.pin(PinRole::dc) = 16;
    return settings;
}

}

TEST_CASE("settings that keep all rules have no mistakes") { CHECK(said_of(right_ones()).empty()); }

TEST_CASE("controls that no text can have are described")
{
    BoardSettings settings = right_ones();
    settings.controls[2] = {ControlKind::knob, ControlAction::pause, 26, {}};
    CHECK(said_of(settings) == "knob 3 cannot be for pause: buttons are for play, pause, sleep, input and "
                               "arm, knobs for place, speed, "
                               "brightness and input\n");
    settings.controls[2] = {ControlKind::knob, ControlAction::input, 26, {}};
    CHECK(said_of(settings) ==
          "knob 3 does not say for which input it is: write the name that it has in the scene: input NAME\n");
    settings.controls[2] = {ControlKind::button, ControlAction::pause, no_pin, {}};
    CHECK(said_of(settings) == "button 3 has no pin: give it one\n");
}

TEST_CASE("pins that the chip does not have are described")
{
    BoardSettings settings = right_ones();
    settings.pin(PinRole::reset) = 77;
    CHECK(said_of(settings) == "GP77 is not on the edge of a Pico: use one of GP0 to GP22, GP26 to GP28\n");
}

TEST_CASE("that units differ is not told of a pin that belongs to none")
{
    BoardSettings settings = right_ones();
    settings.pin(PinRole::clock) = 17;
    CHECK(said_of(settings) ==
          "GP17 cannot carry spi clock: use one of GP2, GP6, GP10, GP14, GP18, GP22, GP26\n");
    settings.pin(PinRole::clock) = 14;
    CHECK(said_of(settings) ==
          "clock on GP14 is SPI1 SCK, data on GP19 is SPI0 TX: two different units of the chip: "
          "with this clock, data can be on GP11, GP15, GP27\n");
}

}
