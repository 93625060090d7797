#include "host/config/config_text.hpp"

#include "host/beam/beam_text.hpp"
#include "host/config/mistake_text.hpp"
#include "host/config/setting_words.hpp"
#include "host/kdl/canonical.hpp"
#include "host/schema/quantity_reader.hpp"
#include "host/schema/value_reader.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace kfast::config {
namespace {

using schema::frequency, schema::quantity_text;

constexpr std::string_view line = "\n    ";
constexpr std::string_view note = "\n    // ";

std::string flag_text(bool flag) { return flag ? "#true" : "#false"; }

/// The shortest share of one that stands for it: three decimals tell all 256 apart.
std::string brightness_text(std::uint8_t brightness)
{
    constexpr double full = 255;
    return schema::shortest_text(brightness / full,
                                 [=](double share) { return std::lround(share * full) == brightness; });
}

std::string panel_text(const BoardSettings& settings)
{
    const PanelSettings& panel = settings.panel;
    std::string text{note};
    text += "The glass, not turned; the picture on it is " + size_text(panel.size());
    text += line;
    text += "panel " + word_of(panel.controller) + ' ' + std::to_string(panel.glass.width) + ' ' +
            std::to_string(panel.glass.height) + " column=" + std::to_string(panel.column) +
            " row=" + std::to_string(panel.row) +
            " rotation=" + std::to_string(90 * static_cast<int>(panel.rotation)) +
            " colours=" + (panel.bgr ? "bgr" : "rgb") + " inverted=" + flag_text(panel.inverted) +
            " brightness=" + brightness_text(panel.brightness);
    if (panel.tearing_effect != (settings.pin(PinRole::tearing) != no_pin))
        text += " tearing=" + flag_text(panel.tearing_effect);
    return text;
}

std::string address_text(std::uint8_t address)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), " address=0x%02X", unsigned{address});
    return text.data();
}

std::string shown_text(const BoardSettings& settings)
{
    if (leads_beam(settings.bus))
        return std::string{note} + "How the beam is led (docs/beam.md)" + std::string{line} +
               beam_text(settings.beam, line.substr(1));
    return panel_text(settings);
}

std::string bus_text(const BoardSettings& settings)
{
    std::string text{note};
    text += "The maker of " + (leads_beam(settings.bus) ? "MCP4922" : word_of(settings.panel.controller)) +
            " allows " + quantity_text(rated_clock(settings), frequency);
    if (clock_warning(settings))
        text += "; many bear more";
    text += line;
    text += "bus " + word_of(settings.bus) + " clock=" + quantity_text(settings.bus_clock, frequency);
    if (settings.bus == BusKind::i2c || settings.i2c_address != BoardSettings{}.i2c_address)
        text += address_text(settings.i2c_address);
    return text;
}

std::string pins_text(const BoardSettings& settings)
{
    std::string text{note};
    text += "Numbers of GPIOs; kfast wiring tells where they are\n    pins";
    for (std::size_t i = 0; i < settings.pins.size(); ++i)
        if (settings.pins[i] != no_pin)
            text += ' ' + std::string{pin_role_names[i]} + '=' + std::to_string(settings.pins[i]);
    return text;
}

std::string control_text(const Control& control)
{
    std::string text{line};
    text += (control.kind == ControlKind::knob ? "knob " : "button ") + std::to_string(control.pin) + ' ' +
            word_of(control.action);
    if (has_name(control.action) && !control.name.view().empty())
        text += ' ' + kdl::string_form(control.name.view());
    return text;
}

std::string clip_text(const StoredName& clip)
{
    if (clip.view().empty())
        return {};
    return std::string{note} + "What plays when nothing is touched" + std::string{line} + "clip " +
           kdl::string_form(clip.view());
}

}

std::string config_text(const BoardSettings& settings)
{
    std::string text = "board pico {" + shown_text(settings) + bus_text(settings) + pins_text(settings) +
                       clip_text(settings.clip);
    for (const Control& control : settings.controls)
        if (control.kind != ControlKind::none)
            text += control_text(control);
    return text + "\n}\n";
}

}
