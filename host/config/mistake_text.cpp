#include "host/config/mistake_text.hpp"

#include "host/config/pico_pins.hpp"
#include "host/config/setting_words.hpp"
#include "host/schema/value_reader.hpp"

#include <algorithm>
#include <cstdio>

namespace kfast::config {
namespace {

using schema::frequency, schema::quantity_text;

constexpr std::uint8_t last_address = 0x77;

/// "clock", "button 3"; for a parallel bus "data (D0 to D7 on GP0 to GP7)".
std::string user_name(PinUser user, const BoardSettings& settings)
{
    if (user.is_control())
        return (settings.controls[user.control()].kind == ControlKind::knob ? "knob " : "button ") +
               std::to_string(user.control() + 1);
    const PinRow row = pins_of(settings, user);
    return row.count > 1 ? word_of(user.role()) + " (D0 to D7 on " + pin_name(row.first) + " to " +
                               pin_name(row.end() - 1) + ')'
                         : word_of(user.role());
}

Finding bus_not_taken_text(const BoardSettings& settings)
{
    std::string taken;
    for (const BusKind bus : {BusKind::spi, BusKind::i2c, BusKind::parallel_8})
        if (facts_of(settings.panel.controller).takes(bus))
            taken += (taken.empty() ? "bus " : " or bus ") + word_of(bus);
    return {word_of(settings.panel.controller) + " cannot be driven by " + word_of(settings.bus),
            "write " + taken};
}

Finding glass_beyond_memory_text(const BoardSettings& settings)
{
    const PanelSettings& panel = settings.panel;
    const Size memory = facts_of(panel.controller).memory;
    const std::string message = "a glass of " + size_text(panel.glass) + " at column " +
                                std::to_string(panel.column) + ", row " + std::to_string(panel.row) +
                                " does not lie within the " + size_text(memory) + " pixels of " +
                                word_of(panel.controller);
    const bool lies_turned = panel.glass.width > memory.width && panel.glass.width <= memory.height &&
                             panel.glass.height <= memory.width;
    if (lies_turned)
        return {message, "give the size of the glass that is not turned, " +
                             std::to_string(panel.glass.height) + ' ' + std::to_string(panel.glass.width) +
                             ", and rotation=90 or 270"};
    return {message, "column and width together are at most " + std::to_string(memory.width) +
                         ", row and height " + std::to_string(memory.height)};
}

Finding glass_ragged_text(const BoardSettings& settings)
{
    const ControllerFacts& facts = facts_of(settings.panel.controller);
    const Size step = addressed_pixels(facts.format);
    return {word_of(settings.panel.controller) + " addresses " + size_text(step) + " pixels at once",
            "let the glass be a multiple of " + size_text(facts.granularity) + ", column and row of " +
                std::to_string(step.width) + " and " + std::to_string(step.height)};
}

Finding clock_text(const BoardSettings& settings, const std::string& wrong)
{
    const ClockRange range = clock_range(settings.bus);
    return {"a Pico has no " + word_of(settings.bus) + " that is so " + wrong,
            "allowed: " + quantity_text(range.min, frequency) + " to " + quantity_text(range.max, frequency)};
}

std::string hex(unsigned value)
{
    std::array<char, 12> text{};
    std::snprintf(text.data(), text.size(), "0x%02X", value);
    return text.data();
}

/// Sellers print the address with the bit for reading or writing after it.
Finding address_text(const BoardSettings& settings)
{
    const std::string message = hex(settings.i2c_address) + " is no address of a display";
    if (settings.i2c_address > last_address)
        return {message, "without the bit for reading and writing it is " + hex(settings.i2c_address / 2U)};
    return {message, "allowed: 0x08 to 0x77, most have 0x3C"};
}

Finding pin_missing_text(PinUser user, const BoardSettings& settings)
{
    if (user.is_control())
        return {user_name(user, settings) + " has no pin", "give it one"};
    const std::string role = word_of(user.role());
    if (user == PinRole::tearing)
        return {"there is no pin for the tearing effect", "add tearing=… to pins, or remove tearing=#true"};
    return {word_of(settings.bus) + " needs a pin for " + role, "add " + role + "=… to pins"};
}

Finding pin_not_on_board_text(PinUser user, const BoardSettings& settings)
{
    const PinRow row = pins_of(settings, user);
    if (row.count > 1)
        return {user_name(user, settings) + " does not lie on the edge of a Pico",
                "let data= be one of 0 to " + std::to_string(last_pin_of_eight)};
    return {pin_name(row.first) + " is not on the edge of a Pico", "use one of " + pins_on_edge()};
}

Finding pin_shared_text(PinUser user, PinUser other, const BoardSettings& settings)
{
    const int pin = std::max(pins_of(settings, user).first, pins_of(settings, other).first);
    return {pin_name(pin) + " is taken twice: by " + user_name(other, settings) + " and by " +
                user_name(user, settings),
            "move one of them; free: " + free_pins(settings)};
}

Finding function_missing_text(PinRole role, const BoardSettings& settings)
{
    const std::string what = role == PinRole::log ? "a log" : word_of(settings.bus) + ' ' + word_of(role);
    return {pin_name(settings.pin(role)) + " cannot carry " + what,
            "use one of " + pins_that_carry(role, settings.bus, std::nullopt)};
}

std::string function_of(PinRole role, const BoardSettings& settings)
{
    return std::string{rp2040::function_name(role, settings.bus, settings.pin(role))};
}

Finding units_differ_text(const BoardSettings& settings)
{
    const auto unit = function_of(PinRole::clock, settings).substr(0, std::string_view{"SPI0"}.size());
    return {"clock on " + pin_name(settings.pin(PinRole::clock)) + " is " +
                function_of(PinRole::clock, settings) + ", data on " + pin_name(settings.pin(PinRole::data)) +
                " is " + function_of(PinRole::data, settings) + ": two different units of the chip",
            "with this clock, data can be on " + pins_that_carry(PinRole::data, settings.bus, unit)};
}

Finding beam_too_fast_text(const BoardSettings& settings)
{
    const std::uint32_t max = rp2040::max_points(settings.bus_clock);
    return {"a bus clock of " + quantity_text(settings.bus_clock, frequency) + " cannot carry " +
                std::to_string(settings.beam.rate) + " points a second",
            "it can carry " + std::to_string(max)};
}

Finding action_text(PinUser user, const BoardSettings& settings)
{
    return {
        user_name(user, settings) + " cannot be for " + word_of(settings.controls[user.control()].action),
        "buttons are for play, pause, sleep, input and arm, knobs for place, speed, brightness and input"};
}

}

std::vector<SettingsMistake> mistakes(const BoardSettings& settings)
{
    std::vector<SettingsMistake> found;
    for (const SettingsRule rule : settings_rules)
        if (const auto mistake = rule(settings))
            found.push_back(*mistake);
    return found;
}

Finding text_of(const SettingsMistake& mistake, const BoardSettings& settings)
{
    switch (mistake.fault) {
    case SettingsFault::bus_not_taken:
        return bus_not_taken_text(settings);
    case SettingsFault::glass_beyond_memory:
        return glass_beyond_memory_text(settings);
    case SettingsFault::glass_ragged:
        return glass_ragged_text(settings);
    case SettingsFault::rotation_not_done:
        return {word_of(settings.panel.controller) + " cannot turn a picture by 90 or 270 degrees",
                "write rotation=0 or 180"};
    case SettingsFault::clock_too_fast:
        return clock_text(settings, "fast");
    case SettingsFault::clock_too_slow:
        return clock_text(settings, "slow");
    case SettingsFault::address_reserved:
        return address_text(settings);
    case SettingsFault::pin_missing:
        return pin_missing_text(*mistake.user, settings);
    case SettingsFault::pin_not_on_board:
        return pin_not_on_board_text(*mistake.user, settings);
    case SettingsFault::pin_shared:
        return pin_shared_text(*mistake.user, *mistake.other, settings);
    case SettingsFault::function_missing:
        return function_missing_text(mistake.user->role(), settings);
    case SettingsFault::units_differ:
        return units_differ_text(settings);
    case SettingsFault::converter_missing:
        return {pin_name(settings.controls[mistake.user->control()].pin) + " cannot measure a knob",
                "use one of GP26 to GP28"};
    case SettingsFault::action_not_of_control:
        return action_text(*mistake.user, settings);
    case SettingsFault::input_missing:
        return {user_name(*mistake.user, settings) + " does not say for which input it is",
                "write the name that it has in the scene: input NAME"};
    case SettingsFault::beam_beyond_limits:
        return {"a number of the beam's profile is beyond its limits", "docs/beam.md tells them"};
    case SettingsFault::beam_too_fast:
        return beam_too_fast_text(settings);
    case SettingsFault::nothing_to_arm:
        return {user_name(*mistake.user, settings) + " arms, but the beam is no laser",
                "write laser=#true for one that is, or remove the button"};
    }
    return {};
}

std::uint32_t rated_clock(const BoardSettings& settings)
{
    const ControllerFacts& facts = facts_of(settings.panel.controller);
    switch (settings.bus) {
    case BusKind::spi:
        return facts.spi_hz;
    case BusKind::i2c:
        return facts.i2c_hz;
    case BusKind::parallel_8:
        return facts.parallel_hz;
    case BusKind::dac:
        return clock_range(BusKind::dac).max;
    }
    return 0;
}

std::optional<Finding> clock_warning(const BoardSettings& settings)
{
    const std::uint32_t rated = rated_clock(settings);
    if (rated == 0 || settings.bus_clock <= rated)
        return std::nullopt;
    const std::string clock = quantity_text(rated, frequency);
    return Finding{"faster than the maker of " + word_of(settings.panel.controller) + " allows, " + clock,
                   "many bear it; if the picture is torn or speckled, write clock=" + clock};
}

}
