#pragma once

#include "firmware/settings/board_settings.hpp"
#include "firmware/settings/controller_facts.hpp"

#include <cstddef>
#include <string>

/// What settings are called in texts and messages.
namespace kfast::config {

inline std::string word_of(Controller controller) { return std::string{controller_name(controller)}; }

inline std::string word_of(BusKind bus) { return std::string{bus_names[static_cast<std::size_t>(bus)]}; }

inline std::string word_of(PinRole role)
{
    return std::string{pin_role_names[static_cast<std::size_t>(role)]};
}

inline std::string word_of(ControlAction action)
{
    return std::string{control_action_names[static_cast<std::size_t>(action)]};
}

/// The firmware that drives displays on this bus: "pico-spi.bin"
inline std::string image_name(BusKind bus)
{
    return "pico-" + (leads_beam(bus) ? "xy" : word_of(bus)) + ".bin";
}

/// What the settings are for: "st7789", or "a beam"
inline std::string display_text(const BoardSettings& settings)
{
    return leads_beam(settings.bus) ? "a beam" : word_of(settings.panel.controller);
}

/// "240 x 320"
inline std::string size_text(Size size)
{
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}
