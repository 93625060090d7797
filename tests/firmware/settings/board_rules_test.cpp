#include "firmware/settings/board_rules.hpp"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

namespace kfast::test {

namespace {

constexpr BoardSettings spi_settings()
{
    BoardSettings settings;
    settings.panel = facts_of(Controller::st7789).default_value;
    settings.bus = BusKind::spi;
    settings.bus_clock = 62'500'000;
    settings.pin(PinRole::clock) = 18;
    settings.pin(PinRole::data) = 19;
    settings.pin(PinRole::select) = 17;
    settings.pin(PinRole::dc) = 20;
    settings.pin(PinRole::log) = 0;
    return settings;
}

constexpr BoardSettings i2c_settings()
{
    BoardSettings settings;
    settings.panel = facts_of(Controller::ssd1306).default_value;
    settings.bus = BusKind::i2c;
    settings.bus_clock = 400'000;
    settings.pin(PinRole::data) = 4;
    settings.pin(PinRole::clock) = 5;
    return settings;
}

constexpr BoardSettings parallel_settings()
{
    BoardSettings settings;
    settings.panel = facts_of(Controller::ili9341).default_value;
    settings.bus = BusKind::parallel_8;
    settings.bus_clock = 15'150'000;
    settings.pin(PinRole::data) = 0;
    settings.pin(PinRole::clock) = 8;
    settings.pin(PinRole::dc) = 9;
    return settings;
}

constexpr BoardSettings dac_settings()
{
    BoardSettings settings;
    settings.beam = scope_profile;
    settings.bus = BusKind::dac;
    settings.bus_clock = 20'000'000;
    settings.pin(PinRole::clock) = 3;
    settings.pin(PinRole::data) = 7;
    settings.pin(PinRole::select) = 28;
    settings.pin(PinRole::ldac) = 0;
    settings.pin(PinRole::blank) = 9;
    return settings;
}

void check_mistake(const BoardSettings& settings, const SettingsMistake& expected)
{
    const MaybeMistake mistake = first_mistake(settings);
    REQUIRE(mistake.has_value());
    CHECK(mistake->fault == expected.fault);
    CHECK(mistake->user == expected.user);
    CHECK(mistake->other == expected.other);
}

constexpr BoardSettings fixed = spi_settings();

}

TEST_CASE("settings that keep all rules have no mistake")
{
    CHECK_FALSE(first_mistake(spi_settings()));
    CHECK_FALSE(first_mistake(i2c_settings()));
    CHECK_FALSE(first_mistake(parallel_settings()));
    CHECK_FALSE(first_mistake(dac_settings()));
    static_assert(right_settings<fixed>() == fixed);
}

TEST_CASE("rules stand in the order of the faults that they find")
{
    BoardSettings settings = spi_settings();
    settings.controls[2] = {ControlKind::button, ControlAction::speed, 21, {}};
    CHECK(settings_rules[static_cast<std::size_t>(SettingsFault::action_not_of_control)](settings));
    CHECK_FALSE(settings_rules[static_cast<std::size_t>(SettingsFault::input_missing)](settings));
    settings.controls[2].action = ControlAction::input;
    CHECK(settings_rules[static_cast<std::size_t>(SettingsFault::input_missing)](settings));
    settings = spi_settings();
    settings.bus = BusKind::parallel_8;
    settings.panel.controller = Controller::gc9a01;
    CHECK(settings_rules[static_cast<std::size_t>(SettingsFault::bus_not_taken)](settings));
}

TEST_CASE("texts stand in the order of the faults that they name")
{
    CHECK(settings_fault_text(SettingsFault::bus_not_taken) ==
          "the display's controller does not speak this bus");
    CHECK(settings_fault_text(SettingsFault::address_reserved) == "the I2C address is reserved");
    CHECK(settings_fault_text(SettingsFault::pin_shared) == "a pin is taken twice");
    CHECK(settings_fault_text(SettingsFault::action_not_of_control) ==
          "the action of a control is not for its kind");
    CHECK(settings_fault_text(SettingsFault::input_missing) == "a control for an input does not name it");
}

TEST_CASE("a controller that does not speak the bus is refused")
{
    BoardSettings settings = parallel_settings();
    settings.panel = facts_of(Controller::gc9a01).default_value;
    check_mistake(settings, {SettingsFault::bus_not_taken});
}

TEST_CASE("a glass must lie within the controller's memory")
{
    BoardSettings settings = spi_settings();
    settings.panel.row = 80;
    CHECK_FALSE(first_mistake(settings));
    for (const auto& [glass, place] :
         std::vector<std::pair<Size, std::pair<int, int>>>{{{240, 240}, {0, 81}},
                                                           {{241, 240}, {0, 0}},
                                                           {{240, 240}, {1, 0}},
                                                           {{240, 0}, {0, 0}},
                                                           {{10, 10}, {0, -1}}}) {
        settings.panel.glass = glass;
        settings.panel.column = place.first;
        settings.panel.row = place.second;
        check_mistake(settings, {SettingsFault::glass_beyond_memory});
    }
}

TEST_CASE("a glass whose pixels share bytes begins and ends with whole bytes")
{
    BoardSettings settings = i2c_settings();
    settings.panel.glass = {72, 40};
    settings.panel.column = 28;
    settings.panel.row = 24;
    CHECK_FALSE(first_mistake(settings));
    settings.panel.row = 20;
    check_mistake(settings, {SettingsFault::glass_ragged});
    settings.panel.row = 0;
    settings.panel.glass = {72, 39};
    check_mistake(settings, {SettingsFault::glass_ragged});
    settings = spi_settings();
    settings.panel = facts_of(Controller::ssd0323).default_value;
    settings.panel.glass = {126, 63};
    settings.panel.column = 1;
    check_mistake(settings, {SettingsFault::glass_ragged});
    settings.panel.column = 2;
    CHECK_FALSE(first_mistake(settings));
}

TEST_CASE("a controller turns pictures as far as it can")
{
    BoardSettings settings = i2c_settings();
    settings.panel.rotation = Rotation::half;
    CHECK_FALSE(first_mistake(settings));
    settings.panel.rotation = Rotation::three_quarters;
    check_mistake(settings, {SettingsFault::rotation_not_done});
}

TEST_CASE("a clock lies between what the chip can make and what displays bear")
{
    const auto with_clock = [](BoardSettings settings, std::uint32_t clock) {
        settings.bus_clock = clock;
        return first_mistake(settings);
    };
    CHECK(with_clock(spi_settings(), 62'500'001)->fault == SettingsFault::clock_too_fast);
    CHECK_FALSE(with_clock(spi_settings(), 1923));
    CHECK(with_clock(spi_settings(), 1922)->fault == SettingsFault::clock_too_slow);
    CHECK(with_clock(spi_settings(), 0)->fault == SettingsFault::clock_too_slow);
    CHECK_FALSE(with_clock(i2c_settings(), 1'000'000));
    CHECK(with_clock(i2c_settings(), 1'000'001)->fault == SettingsFault::clock_too_fast);
    CHECK(with_clock(i2c_settings(), 0)->fault == SettingsFault::clock_too_slow);
    CHECK_FALSE(with_clock(parallel_settings(), 15'151'515));
    CHECK(with_clock(parallel_settings(), 15'151'516)->fault == SettingsFault::clock_too_fast);
    CHECK(with_clock(parallel_settings(), 0)->fault == SettingsFault::clock_too_slow);
}

TEST_CASE("an I2C address is one that displays may have")
{
    BoardSettings settings = i2c_settings();
    settings.i2c_address = 0x78; // 0x3C with the bit for writing
    check_mistake(settings, {SettingsFault::address_reserved});
    settings.i2c_address = 7;
    check_mistake(settings, {SettingsFault::address_reserved});
    settings.i2c_address = 0x77;
    CHECK_FALSE(first_mistake(settings));
}

TEST_CASE("a role that the bus or the display needs has a pin")
{
    for (const PinRole role : {PinRole::clock, PinRole::data, PinRole::dc}) {
        BoardSettings settings = parallel_settings();
        settings.pin(role) = no_pin;
        check_mistake(settings, {SettingsFault::pin_missing, role});
    }
    BoardSettings settings = spi_settings();
    settings.pin(PinRole::select) = no_pin;
    CHECK_FALSE(first_mistake(settings));
    settings.panel.tearing_effect = true;
    check_mistake(settings, {SettingsFault::pin_missing, PinRole::tearing});
    settings = spi_settings();
    settings.controls[3] = {ControlKind::knob, ControlAction::speed, no_pin, {}};
    check_mistake(settings, {SettingsFault::pin_missing, PinUser::of_control(3)});
}

TEST_CASE("a pin is one that a wire can be put on")
{
    BoardSettings settings = spi_settings();
    for (const Pin pin : std::array<Pin, 6>{23, 24, 25, 29, 30, 254}) {
        settings.pin(PinRole::reset) = pin;
        check_mistake(settings, {SettingsFault::pin_not_on_board, PinRole::reset});
    }
    settings = parallel_settings();
    settings.pin(PinRole::data) = 15;
    CHECK_FALSE(first_mistake(settings));
    settings.pin(PinRole::data) = 16;
    check_mistake(settings, {SettingsFault::pin_not_on_board, PinRole::data});
}

TEST_CASE("nobody shares a pin")
{
    BoardSettings settings = spi_settings();
    settings.pin(PinRole::backlight) = 20;
    check_mistake(settings, {SettingsFault::pin_shared, PinRole::backlight, PinRole::dc});
    settings = parallel_settings();
    settings.pin(PinRole::reset) = 7;
    check_mistake(settings, {SettingsFault::pin_shared, PinRole::reset, PinRole::data});
    settings = spi_settings();
    settings.controls[1] = {ControlKind::button, ControlAction::play, 22, {}};
    settings.controls[4] = {ControlKind::button, ControlAction::pause, 22, {}};
    check_mistake(settings, {SettingsFault::pin_shared, PinUser::of_control(4), PinUser::of_control(1)});
    settings.controls[4].kind = ControlKind::none;
    CHECK_FALSE(first_mistake(settings));
}

TEST_CASE("clock, data and log lie where their units reach")
{
    BoardSettings settings = spi_settings();
    settings.pin(PinRole::clock) = 21;
    check_mistake(settings, {SettingsFault::function_missing, PinRole::clock});
    settings = spi_settings();
    settings.pin(PinRole::data) = 16;
    check_mistake(settings, {SettingsFault::function_missing, PinRole::data});
    settings = i2c_settings();
    settings.pin(PinRole::data) = 3;
    check_mistake(settings, {SettingsFault::function_missing, PinRole::data});
    settings = spi_settings();
    settings.pin(PinRole::log) = 1;
    check_mistake(settings, {SettingsFault::function_missing, PinRole::log});
}

TEST_CASE("clock and data belong to one unit")
{
    BoardSettings settings = spi_settings();
    settings.pin(PinRole::data) = 11;
    check_mistake(settings, {SettingsFault::units_differ, PinRole::data, PinRole::clock});
    settings = i2c_settings();
    settings.pin(PinRole::clock) = 7;
    check_mistake(settings, {SettingsFault::units_differ, PinRole::data, PinRole::clock});
}

TEST_CASE("controls have pins and actions of their kind")
{
    BoardSettings settings = spi_settings();
    settings.controls[5] = {ControlKind::knob, ControlAction::place, 22, {}};
    check_mistake(settings, {SettingsFault::converter_missing, PinUser::of_control(5)});
    settings.controls[5].pin = 28;
    CHECK_FALSE(first_mistake(settings));
    settings.controls[5].action = ControlAction::pause;
    check_mistake(settings, {SettingsFault::action_not_of_control, PinUser::of_control(5)});
}

TEST_CASE("buttons and knobs may be for an input, which they must name")
{
    for (const ControlKind kind : {ControlKind::button, ControlKind::knob}) {
        BoardSettings settings = spi_settings();
        settings.controls[5] = {kind, ControlAction::input, 28, {"gaze"}};
        CHECK_FALSE(first_mistake(settings));
        settings.controls[5].name = {};
        check_mistake(settings, {SettingsFault::input_missing, PinUser::of_control(5)});
    }
    BoardSettings settings = spi_settings();
    settings.controls[5].action = ControlAction::input;
    CHECK_FALSE(first_mistake(settings)); // there is no such control
}

TEST_CASE("the pins of the chip are what its maker's table says")
{
    using namespace rp2040;
    CHECK(function_name(PinRole::clock, BusKind::spi, 2) == "SPI0 SCK");
    CHECK(function_name(PinRole::data, BusKind::spi, 7) == "SPI0 TX");
    CHECK(function_name(PinRole::clock, BusKind::spi, 10) == "SPI1 SCK");
    CHECK(function_name(PinRole::data, BusKind::spi, 19) == "SPI0 TX");
    CHECK(function_name(PinRole::data, BusKind::spi, 27) == "SPI1 TX");
    CHECK(function_name(PinRole::data, BusKind::i2c, 0) == "I2C0 SDA");
    CHECK(function_name(PinRole::clock, BusKind::i2c, 27) == "I2C1 SCL");
    CHECK(function_name(PinRole::log, BusKind::spi, 0) == "UART0 TX");
    CHECK(function_name(PinRole::log, BusKind::spi, 4) == "UART1 TX");
    CHECK(function_name(PinRole::log, BusKind::spi, 8) == "UART1 TX");
    CHECK(function_name(PinRole::log, BusKind::spi, 12) == "UART0 TX");
    CHECK(function_name(PinRole::log, BusKind::spi, 28) == "UART0 TX");
    CHECK(function_name(PinRole::clock, BusKind::parallel_8, 2).empty());
    CHECK(function_name(PinRole::clock, BusKind::spi, no_pin).empty());
    CHECK(converter_input(26) == 0);
    CHECK_FALSE(converter_input(30));
    CHECK(pulse_output(17).slice == 0);
    CHECK(pulse_output(17).channel == 1);
    CHECK(pulse_output(15).slice == 7);
}

TEST_CASE("the pins of a Pico are those of its pinout")
{
    CHECK(rp2040::pico_pins[0] == 1);
    CHECK(rp2040::pico_pins[2] == 4);
    CHECK(rp2040::pico_pins[15] == 20);
    CHECK(rp2040::pico_pins[16] == 21);
    CHECK(rp2040::pico_pins[22] == 29);
    CHECK(rp2040::pico_pins[28] == 34);
    for (const std::uint8_t ground : rp2040::pico_ground_pins)
        CHECK(std::ranges::find(rp2040::pico_pins, ground) == rp2040::pico_pins.end());
}

TEST_CASE("a beam needs the wires of its converters, whatever a panel would need")
{
    for (const PinRole role :
         {PinRole::clock, PinRole::data, PinRole::select, PinRole::ldac, PinRole::blank}) {
        BoardSettings settings = dac_settings();
        settings.pin(role) = no_pin;
        check_mistake(settings, {SettingsFault::pin_missing, role});
    }
    BoardSettings settings = dac_settings();
    settings.panel = {.controller = Controller::ssd1306, .glass = {0, 7}, .rotation = Rotation::quarter};
    settings.panel.tearing_effect = true;
    CHECK_FALSE(first_mistake(settings));
}

TEST_CASE("a beam's clock is one that its converters take")
{
    BoardSettings settings = dac_settings();
    settings.bus_clock = 20'000'001;
    check_mistake(settings, {SettingsFault::clock_too_fast, PinRole::clock});
    settings.bus_clock = 0;
    check_mistake(settings, {SettingsFault::clock_too_slow, PinRole::clock});
}

TEST_CASE("a beam's profile keeps its limits")
{
    const auto check_refused = [](auto change) {
        BoardSettings settings = dac_settings();
        change(settings.beam);
        check_mistake(settings, {SettingsFault::beam_beyond_limits});
    };
    check_refused([](BeamProfile& beam) { beam.rate = 999; });
    check_refused([](BeamProfile& beam) { beam.rate = 1'000'001; });
    check_refused([](BeamProfile& beam) { beam.lit_step = 0; });
    check_refused([](BeamProfile& beam) { beam.min_refresh = 0; });
    check_refused([](BeamProfile& beam) { beam.resolution = 32; });
    check_refused([](BeamProfile& beam) { beam.resolution = 96; });
    check_refused([](BeamProfile& beam) { beam.resolution = 8192; });
    BoardSettings panel = spi_settings();
    panel.beam.rate = 0;
    CHECK_FALSE(first_mistake(panel));
}

TEST_CASE("the bus carries as many points as the beam wants")
{
    BoardSettings settings = dac_settings();
    settings.beam.rate = rp2040::max_points(settings.bus_clock);
    CHECK(settings.beam.rate >= 450'000);
    CHECK_FALSE(first_mistake(settings));
    ++settings.beam.rate;
    check_mistake(settings, {SettingsFault::beam_too_fast, PinRole::clock});
    settings.beam.rate = 30'000;
    settings.bus_clock = 1'000'000;
    check_mistake(settings, {SettingsFault::beam_too_fast, PinRole::clock});
    settings.bus_clock = 1'200'000;
    CHECK_FALSE(first_mistake(settings));
}

TEST_CASE("only a laser is armed")
{
    BoardSettings settings = dac_settings();
    settings.controls[1] = {ControlKind::button, ControlAction::arm, 12, {}};
    check_mistake(settings, {SettingsFault::nothing_to_arm, PinUser::of_control(1)});
    settings.beam.is_laser = true;
    CHECK_FALSE(first_mistake(settings));
    settings.controls[1] = {ControlKind::knob, ControlAction::arm, 27, {}};
    check_mistake(settings, {SettingsFault::action_not_of_control, PinUser::of_control(1)});
    settings = spi_settings();
    settings.beam.is_laser = true;
    settings.controls[1] = {ControlKind::button, ControlAction::arm, 12, {}};
    check_mistake(settings, {SettingsFault::nothing_to_arm, PinUser::of_control(1)});
}

}
