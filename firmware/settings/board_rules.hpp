#pragma once

#include "firmware/settings/controller_facts.hpp"
#include "firmware/settings/rp2040_beam.hpp"
#include "firmware/settings/rp2040_pins.hpp"
#include "firmware/settings/settings_mistake.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace kfast {

/// Neighbouring pins.
struct PinRow {
    int first = 0;
    int count = 0; ///< 0: none

    constexpr int end() const { return first + count; }
};

constexpr PinRow pins_of(const BoardSettings& settings, PinUser user)
{
    if (user.is_control()) {
        const Control& control = settings.controls[user.control()];
        const bool is_wired = control.kind != ControlKind::none && control.pin != no_pin;
        return is_wired ? PinRow{control.pin, 1} : PinRow{};
    }
    const Pin pin = settings.pin(user.role());
    if (pin == no_pin)
        return {};
    return {pin, settings.bus == BusKind::parallel_8 && user == PinRole::data ? 8 : 1};
}

/// Hz.
struct ClockRange {
    std::uint32_t min;
    std::uint32_t max;
};

/// The clocks that a Pico can make, up to what displays take: 66 ns are the shortest write cycle of all
/// parallel ones, and an MCP4922 takes 20 MHz. The slowest is the limit of the units' dividers
/// (boards/pico/panel/bus_rates.hpp).
constexpr ClockRange clock_range(BusKind bus)
{
    constexpr std::uint32_t chip = rp2040::default_hz;
    if (bus == BusKind::dac)
        return {chip / (rp2040::DacBit::longest * 65'535) + 1, 20'000'000};
    if (bus == BusKind::spi)
        return {chip / (254 * 256) + 1, chip / 2};
    if (bus == BusKind::i2c)
        return {chip / 100'000, 1'000'000};
    return {chip / (32 * 65'535) + 1, 1'000'000'000 / 66};
}

/// Whether a display on the bus cannot do without the role.
constexpr bool needs(const BoardSettings& settings, PinRole role)
{
    switch (role) {
    case PinRole::clock:
    case PinRole::data:
        return true;
    case PinRole::dc:
        return settings.bus != BusKind::i2c && !leads_beam(settings.bus);
    case PinRole::tearing:
        return settings.panel.tearing_effect && !leads_beam(settings.bus);
    case PinRole::select:
    case PinRole::ldac:
    case PinRole::blank:
        return leads_beam(settings.bus);
    case PinRole::reset:
    case PinRole::backlight:
    case PinRole::log:
        break;
    }
    return false;
}

constexpr bool needs_pin(const BoardSettings& settings, PinUser user)
{
    return user.is_control() ? settings.controls[user.control()].kind != ControlKind::none
                             : needs(settings, user.role());
}

// Each rule: the first mistake, if any.

constexpr MaybeMistake bus_not_taken(const BoardSettings& settings)
{
    if (leads_beam(settings.bus) || facts_of(settings.panel.controller).takes(settings.bus))
        return std::nullopt;
    return SettingsMistake{SettingsFault::bus_not_taken};
}

constexpr MaybeMistake glass_beyond_memory(const BoardSettings& settings)
{
    if (leads_beam(settings.bus))
        return std::nullopt;
    const PanelSettings& panel = settings.panel;
    const Size memory = facts_of(panel.controller).memory;
    constexpr auto lies_within = [](int begin, int length, int max) {
        return begin >= 0 && begin <= max && length > 0 && length <= max - begin;
    };
    if (lies_within(panel.column, panel.glass.width, memory.width) &&
        lies_within(panel.row, panel.glass.height, memory.height))
        return std::nullopt;
    return SettingsMistake{SettingsFault::glass_beyond_memory};
}

/// The pixels in one byte of a controller's memory, or in one word of colours.
constexpr Size addressed_pixels(PixelFormat format)
{
    if (format == PixelFormat::mono1)
        return {1, 8};
    return format == PixelFormat::grey4 ? Size{2, 1} : Size{1, 1};
}

constexpr MaybeMistake glass_ragged(const BoardSettings& settings)
{
    if (leads_beam(settings.bus))
        return std::nullopt;
    const PanelSettings& panel = settings.panel;
    const ControllerFacts& facts = facts_of(panel.controller);
    const Size step = addressed_pixels(facts.format);
    if (panel.glass.width % facts.granularity.width == 0 &&
        panel.glass.height % facts.granularity.height == 0 && panel.column % step.width == 0 &&
        panel.row % step.height == 0)
        return std::nullopt;
    return SettingsMistake{SettingsFault::glass_ragged};
}

constexpr MaybeMistake rotation_not_done(const BoardSettings& settings)
{
    if (leads_beam(settings.bus) || facts_of(settings.panel.controller).turns_across ||
        !lies_across(settings.panel.rotation))
        return std::nullopt;
    return SettingsMistake{SettingsFault::rotation_not_done};
}

constexpr MaybeMistake clock_too_fast(const BoardSettings& settings)
{
    if (settings.bus_clock <= clock_range(settings.bus).max)
        return std::nullopt;
    return SettingsMistake{SettingsFault::clock_too_fast, PinRole::clock};
}

constexpr MaybeMistake clock_too_slow(const BoardSettings& settings)
{
    if (settings.bus_clock >= clock_range(settings.bus).min)
        return std::nullopt;
    return SettingsMistake{SettingsFault::clock_too_slow, PinRole::clock};
}

constexpr MaybeMistake address_reserved(const BoardSettings& settings)
{
    constexpr std::uint8_t first = 0x08;
    constexpr std::uint8_t last = 0x77;
    if (settings.bus != BusKind::i2c || (settings.i2c_address >= first && settings.i2c_address <= last))
        return std::nullopt;
    return SettingsMistake{SettingsFault::address_reserved};
}

constexpr MaybeMistake pin_missing(const BoardSettings& settings)
{
    for (std::size_t i = 0; i < PinUser::count; ++i) {
        const PinUser user = PinUser::number(i);
        if (needs_pin(settings, user) && pins_of(settings, user).count == 0)
            return SettingsMistake{SettingsFault::pin_missing, user};
    }
    return std::nullopt;
}

constexpr bool lie_on_board(PinRow row)
{
    for (int pin = row.first; pin < row.end(); ++pin) {
        if (pin >= rp2040::pin_count || !rp2040::is_on_pico_edge(static_cast<Pin>(pin)))
            return false;
    }
    return true;
}

constexpr MaybeMistake pin_not_on_board(const BoardSettings& settings)
{
    for (std::size_t i = 0; i < PinUser::count; ++i) {
        const PinUser user = PinUser::number(i);
        if (!lie_on_board(pins_of(settings, user)))
            return SettingsMistake{SettingsFault::pin_not_on_board, user};
    }
    return std::nullopt;
}

constexpr bool overlap(PinRow one, PinRow other)
{
    return one.count > 0 && other.count > 0 && one.first < other.end() && other.first < one.end();
}

constexpr MaybeMistake pin_shared(const BoardSettings& settings)
{
    for (std::size_t i = 0; i < PinUser::count; ++i) {
        for (std::size_t earlier = 0; earlier < i; ++earlier) {
            const PinUser user = PinUser::number(i);
            const PinUser other = PinUser::number(earlier);
            if (overlap(pins_of(settings, user), pins_of(settings, other)))
                return SettingsMistake{SettingsFault::pin_shared, user, other};
        }
    }
    return std::nullopt;
}

/// Whether clock and data must end at a certain unit of the chip. State machines reach every pin.
constexpr bool is_unit_bus(BusKind bus) { return bus == BusKind::spi || bus == BusKind::i2c; }

/// Whether a role's wire must end at a certain unit of the chip.
constexpr bool needs_function(PinRole role, BusKind bus)
{
    return role == PinRole::log || (is_unit_bus(bus) && (role == PinRole::clock || role == PinRole::data));
}

constexpr MaybeMistake function_missing(const BoardSettings& settings)
{
    for (const PinRole role : {PinRole::clock, PinRole::data, PinRole::log}) {
        const Pin pin = settings.pin(role);
        if (pin != no_pin && needs_function(role, settings.bus) &&
            rp2040::function_name(role, settings.bus, pin).empty())
            return SettingsMistake{SettingsFault::function_missing, role};
    }
    return std::nullopt;
}

constexpr MaybeMistake units_differ(const BoardSettings& settings)
{
    if (!is_unit_bus(settings.bus))
        return std::nullopt;
    const bool is_spi = settings.bus == BusKind::spi;
    const Pin clock_pin = settings.pin(PinRole::clock);
    const Pin data_pin = settings.pin(PinRole::data);
    const auto clock = is_spi ? rp2040::spi_clock_unit(clock_pin) : rp2040::i2c_clock_unit(clock_pin);
    const auto data = is_spi ? rp2040::spi_data_unit(data_pin) : rp2040::i2c_data_unit(data_pin);
    if (!clock || !data || *clock == *data)
        return std::nullopt;
    return SettingsMistake{SettingsFault::units_differ, PinRole::data, PinRole::clock};
}

constexpr MaybeMistake converter_missing(const BoardSettings& settings)
{
    for (std::size_t i = 0; i < settings.controls.size(); ++i) {
        const Control& control = settings.controls[i];
        const bool is_wired_knob = control.kind == ControlKind::knob && control.pin != no_pin;
        if (is_wired_knob && !rp2040::converter_input(control.pin))
            return SettingsMistake{SettingsFault::converter_missing, PinUser::of_control(i)};
    }
    return std::nullopt;
}

constexpr MaybeMistake action_not_of_control(const BoardSettings& settings)
{
    for (std::size_t i = 0; i < settings.controls.size(); ++i) {
        const Control& control = settings.controls[i];
        if (control.kind != ControlKind::none && !is_for(control.action, control.kind))
            return SettingsMistake{SettingsFault::action_not_of_control, PinUser::of_control(i)};
    }
    return std::nullopt;
}

constexpr MaybeMistake input_missing(const BoardSettings& settings)
{
    for (std::size_t i = 0; i < settings.controls.size(); ++i) {
        const Control& control = settings.controls[i];
        if (control.kind != ControlKind::none && has_input(control.action) && control.name.view().empty())
            return SettingsMistake{SettingsFault::input_missing, PinUser::of_control(i)};
    }
    return std::nullopt;
}

constexpr MaybeMistake beam_beyond_limits(const BoardSettings& settings)
{
    if (!leads_beam(settings.bus) || is_within_limits(settings.beam))
        return std::nullopt;
    return SettingsMistake{SettingsFault::beam_beyond_limits};
}

constexpr MaybeMistake beam_too_fast(const BoardSettings& settings)
{
    const ClockRange clocks = clock_range(BusKind::dac);
    if (!leads_beam(settings.bus) || settings.bus_clock < clocks.min || settings.bus_clock > clocks.max ||
        settings.beam.rate <= rp2040::max_points(settings.bus_clock))
        return std::nullopt;
    return SettingsMistake{SettingsFault::beam_too_fast, PinRole::clock};
}

constexpr MaybeMistake nothing_to_arm(const BoardSettings& settings)
{
    if (leads_beam(settings.bus) && settings.beam.is_laser)
        return std::nullopt;
    for (std::size_t i = 0; i < settings.controls.size(); ++i) {
        const Control& control = settings.controls[i];
        if (control.kind != ControlKind::none && control.action == ControlAction::arm)
            return SettingsMistake{SettingsFault::nothing_to_arm, PinUser::of_control(i)};
    }
    return std::nullopt;
}

using SettingsRule = MaybeMistake (*)(const BoardSettings&);

/// In the order of SettingsFault.
inline constexpr std::array<SettingsRule, settings_fault_texts.size()> settings_rules{
    bus_not_taken,      glass_beyond_memory, glass_ragged,      rotation_not_done,     clock_too_fast,
    clock_too_slow,     address_reserved,    pin_missing,       pin_not_on_board,      pin_shared,
    function_missing,   units_differ,        converter_missing, action_not_of_control, input_missing,
    beam_beyond_limits, beam_too_fast,       nothing_to_arm,
};

/// The first mistake in settings for a Pico; nothing if they can be used as they are.
constexpr MaybeMistake first_mistake(const BoardSettings& settings)
{
    for (const SettingsRule rule : settings_rules) {
        if (const MaybeMistake mistake = rule(settings))
            return mistake;
    }
    return std::nullopt;
}

/// The same settings, at compile time: compiling ends with a message for each rule that they break.
template <const BoardSettings& settings>
consteval const BoardSettings& right_settings()
{
    static_assert(!bus_not_taken(settings), "settings: the display controller does not speak this bus");
    static_assert(!glass_beyond_memory(settings),
                  "settings: the glass does not lie within the controller's memory");
    static_assert(!glass_ragged(settings), "settings: sides or place of the glass are not multiples of the "
                                           "controller's granularity");
    static_assert(!rotation_not_done(settings), "settings: the controller cannot turn pictures by quarters");
    static_assert(!clock_too_fast(settings),
                  "settings: bus_clock is above 62.5 MHz (SPI), 1 MHz (I2C), 20 MHz (DAC) or a "
                  "write every 66 ns (parallel)");
    static_assert(!clock_too_slow(settings), "settings: bus_clock is 0 or too low to be made");
    static_assert(!address_reserved(settings), "settings: i2c_address is not one of 0x08 to 0x77");
    static_assert(!pin_missing(settings), "settings: the bus, the tearing effect or a control lacks a pin");
    static_assert(!pin_not_on_board(settings),
                  "settings: a pin is not on the edge of a Pico (0 to 22, 26 to 28; a "
                  "parallel bus takes eight from the data pin on)");
    static_assert(!pin_shared(settings),
                  "settings: two roles or controls have the same pin (a parallel bus takes "
                  "eight from the data pin on)");
    static_assert(!function_missing(settings),
                  "settings: clock, data or log lies on a pin that does not carry its "
                  "function (SCK, TX; SCL, SDA; UART TX)");
    static_assert(!units_differ(settings), "settings: clock and data belong to different units of the chip");
    static_assert(!converter_missing(settings), "settings: a knob needs one of the pins 26 to 28");
    static_assert(!action_not_of_control(settings), "settings: a control's action is not for its kind");
    static_assert(!input_missing(settings), "settings: a control for an input does not name it");
    static_assert(!beam_beyond_limits(settings),
                  "settings: a number of the beam's profile is beyond its limits");
    static_assert(!beam_too_fast(settings), "settings: bus_clock is too slow for the beam's rate");
    static_assert(!nothing_to_arm(settings), "settings: a button arms, but the beam is no laser");
    return settings;
}

}
