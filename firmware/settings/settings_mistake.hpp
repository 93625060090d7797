#pragma once

#include "core/bytes/expects.hpp"
#include "firmware/settings/board_settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace kfast {

/// What can be wrong with settings for a Pico, in the order in which it is looked for.
enum class SettingsFault : std::uint8_t {
    bus_not_taken,         ///< the controller does not speak this bus
    glass_beyond_memory,   ///< the glass is empty, or is not within the controller's memory
    glass_ragged,          ///< sides or position of the glass are no multiples of what can be addressed
    rotation_not_done,     ///< the controller cannot rotate pictures by quarters
    clock_too_fast,        ///< for the chip, or for every display on this bus
    clock_too_slow,        ///< 0, or less than the chip can divide down to
    address_reserved,      ///< the bus keeps this I²C address for itself, or it has more than seven bits
    pin_missing,           ///< of a role that the display or the bus needs, or of a control
    pin_not_on_board,      ///< the chip has no such pin, or the board keeps it for itself
    pin_shared,            ///< two uses of one pin
    function_missing,      ///< the pin does not carry what the role needs
    units_differ,          ///< clock and data belong to different units of the chip
    converter_missing,     ///< a knob on a pin that cannot measure
    action_not_of_control, ///< buttons and knobs do different things
    input_missing,         ///< a control for an input does not name it
    beam_beyond_limits,    ///< a number of the beam's profile is not one that it can have
    beam_too_fast,         ///< more points in a second than the bus clock can carry
    nothing_to_arm,        ///< a button that arms, but no dangerous beam
};

/// In the order of SettingsFault.
inline constexpr std::array<std::string_view, 18> settings_fault_texts{
    "the display's controller does not speak this bus",
    "the glass does not lie within the controller's memory",
    "the glass is no multiple of what the controller can address",
    "the controller cannot turn pictures by quarters",
    "the bus clock is too fast",
    "the bus clock is too slow",
    "the I2C address is reserved",
    "a pin is missing",
    "a pin is not on the edge of the board",
    "a pin is taken twice",
    "a pin cannot carry what it is for",
    "clock and data belong to different units of the chip",
    "the pin of a knob cannot measure",
    "the action of a control is not for its kind",
    "a control for an input does not name it",
    "the beam's profile is beyond its limits",
    "the bus clock is too slow for the beam's rate",
    "a button arms, but the beam is no laser",
};

constexpr std::string_view settings_fault_text(SettingsFault fault)
{
    return settings_fault_texts[static_cast<std::size_t>(fault)];
}

/// What needs a pin: a role, or one of the controls.
class PinUser {
public:
    static constexpr std::size_t count = pin_role_names.size() + BoardSettings::max_controls;

    constexpr PinUser(PinRole role) : number_{static_cast<std::size_t>(role)} {}
    static constexpr PinUser of_control(std::size_t index) { return PinUser{pin_role_names.size() + index}; }
    /// All roles, then all controls.
    static constexpr PinUser number(std::size_t number) { return PinUser{number}; }

    constexpr bool is_control() const { return number_ >= pin_role_names.size(); }
    /// Its role; only if it is no control.
    constexpr PinRole role() const
    {
        expects(!is_control());
        return static_cast<PinRole>(number_);
    }
    /// Its index in BoardSettings::controls. Only if it is a control.
    constexpr std::size_t control() const
    {
        expects(is_control());
        return number_ - pin_role_names.size();
    }

    friend constexpr bool operator==(PinUser, PinUser) = default;

private:
    constexpr explicit PinUser(std::size_t number) : number_{number} {}

    std::size_t number_;
};

/// A broken rule, and what breaks it.
struct SettingsMistake {
    SettingsFault fault;
    std::optional<PinUser> user = std::nullopt;  ///< of faults that concern a pin or a control
    std::optional<PinUser> other = std::nullopt; ///< of pin_shared and units_differ: what it collides with

    friend constexpr bool operator==(const SettingsMistake&, const SettingsMistake&) = default;
};

using MaybeMistake = std::optional<SettingsMistake>;

}
