#pragma once

#include "core/beam/beam_profile.hpp"
#include "firmware/chip/stored_text.hpp"
#include "firmware/settings/panel_settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kfast {

/// The wires between a chip and its display. Stored.
enum class BusKind : std::uint8_t {
    spi,
    i2c,
    parallel_8,
    dac, ///< to the two converters that move a beam, each word by SPI: an MCP4922 or one with the same
         ///< protocol
};

/// In the order of BusKind.
inline constexpr std::array<std::string_view, 4> bus_names{"spi", "i2c", "parallel", "dac"};

/// Whether there is a beam at the other end rather than a panel.
constexpr bool leads_beam(BusKind bus) { return bus == BusKind::dac; }

/// What a pin of the chip is wired to. Stored.
enum class PinRole : std::uint8_t {
    clock,     ///< SCK, SCL, or WR of a parallel bus
    data,      ///< MOSI, SDA, or D0 of a parallel bus, whose D1 … D7 are the pins after it
    select,    ///< CS
    dc,        ///< D/C, RS of a parallel bus
    reset,     ///< of the display
    backlight, ///< lit when high, dimmed by pulses
    tearing,   ///< TE: the display signals that it has shown a picture
    log,       ///< the board reports what it does, for a serial terminal at 115200 baud
    ldac,      ///< LDAC: both converters take over what they were sent
    blank,     ///< the beam is dark when high
};

/// In the order of PinRole.
inline constexpr std::array<std::string_view, 10> pin_role_names{
    "clock", "data", "select", "dc", "reset", "backlight", "tearing", "log", "ldac", "blank",
};

/// The number of a pin as the chip's maker counts, or no_pin.
using Pin = std::uint8_t;
inline constexpr Pin no_pin = 0xFF;

/// The longest name of a clip or an input that settings can have, in bytes.
inline constexpr std::size_t longest_stored_name = 24;
using StoredName = StoredText<longest_stored_name>;

/// What people operate. Stored.
enum class ControlKind : std::uint8_t {
    none,
    button, ///< a switch from the pin to ground
    knob,   ///< a potentiometer between ground and the supply, its slider on a pin with a converter
};

/// What a control does. Stored.
enum class ControlAction : std::uint8_t {
    play,  ///< button: plays the clip from its beginning, and what was played before when it has finished
    pause, ///< button: stops playing, and continues
    sleep, ///< button: switches the display off, and on
    place, ///< knob: where playing is in the clip, or in the whole scene
    speed, ///< knob: from backwards to twice as fast, stopped in the middle
    brightness, ///< knob: of the display
    input, ///< knob: the place of an input of the scene; button: its maximum while pressed, else its minimum
    arm,   ///< button: lets a dangerous beam shine, and makes it dark again
};

/// In the order of ControlAction.
inline constexpr std::array<std::string_view, 8> control_action_names{
    "play", "pause", "sleep", "place", "speed", "brightness", "input", "arm",
};

constexpr bool is_for(ControlAction action, ControlKind kind)
{
    if (action == ControlAction::input)
        return kind != ControlKind::none;
    const bool is_for_button = action <= ControlAction::sleep || action == ControlAction::arm;
    return (kind == ControlKind::button) == is_for_button && kind != ControlKind::none;
}

/// Whether it can be about one clip, rather than the whole scene.
constexpr bool has_clip(ControlAction action)
{
    return action == ControlAction::play || action == ControlAction::place;
}

/// Whether it is about one input of the scene, which it must name.
constexpr bool has_input(ControlAction action) { return action == ControlAction::input; }

constexpr bool has_name(ControlAction action) { return has_clip(action) || has_input(action); }

struct Control {
    ControlKind kind = ControlKind::none;
    ControlAction action = ControlAction::play;
    Pin pin = no_pin;
    StoredName name; ///< of the clip, empty for the whole scene, or of the input; else empty

    friend constexpr bool operator==(const Control&, const Control&) = default;
};

/// Everything about one gadget that its firmware does not know by itself: the display, the wires, the
/// controls. It is in a sector of flash (board_record.hpp), so that nobody needs a compiler to move a wire.
struct BoardSettings {
    static constexpr std::size_t max_controls = 8;

    PanelSettings panel; ///< unless the bus leads a beam
    BeamProfile beam;    ///< if the bus leads a beam
    BusKind bus = BusKind::spi;
    /// Hz: bits of SPI, I²C and of converters, writes of a parallel bus. The chip takes the next lower one
    /// that it can make.
    std::uint32_t bus_clock = 0;
    std::uint8_t i2c_address = 0x3C;                         ///< seven bits
    std::array<Pin, pin_role_names.size()> pins = no_pins(); ///< in the order of PinRole
    StoredName clip;                                         ///< played when no control is used; empty: all
    std::array<Control, max_controls> controls{};

    constexpr Pin pin(PinRole role) const { return pins[static_cast<std::size_t>(role)]; }
    constexpr Pin& pin(PinRole role) { return pins[static_cast<std::size_t>(role)]; }

    friend constexpr bool operator==(const BoardSettings&, const BoardSettings&) = default;

private:
    static constexpr std::array<Pin, pin_role_names.size()> no_pins()
    {
        std::array<Pin, pin_role_names.size()> pins{};
        pins.fill(no_pin);
        return pins;
    }
};

}
