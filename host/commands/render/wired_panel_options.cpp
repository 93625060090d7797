#include "host/commands/render/wired_panel_options.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/config/mistake_text.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"
#include "host/wired/spi_device.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace kfast {
namespace {

constexpr std::uint32_t parallel_lines = 0xFF | line_bit(LineRole::write) | line_bit(LineRole::dc);
constexpr std::uint32_t only_parallel_lines = 0xFF | line_bit(LineRole::write);

[[noreturn]] void refuse(const std::string& option, const std::string& message)
{
    throw CLI::ValidationError(option, message);
}

LineRole read_role(std::string_view name)
{
    const auto found = std::ranges::find(line_role_names, name);
    if (found == line_role_names.end())
        refuse("--pin",
               "'" + visible(name) + "' is nothing on a display: " + suggestion(name, line_role_names));
    return static_cast<LineRole>(found - line_role_names.begin());
}

void read_pin(const std::string& text, LineNames& lines)
{
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos || sign + 1 == text.size())
        refuse("--pin", "'" + visible(text) + "' names no line: write it like dc=GPIO25 or dc=25");
    const LineRole role = read_role(std::string_view{text}.substr(0, sign));
    if (!lines.emplace(role, text.substr(sign + 1)).second)
        refuse("--pin", "there are two lines for " + std::string{line_role_name(role)} + ": leave out one");
}

BusKind read_bus(const std::string& name)
{
    if (name == bus_names[static_cast<std::size_t>(BusKind::spi)])
        return BusKind::spi;
    if (name == bus_names[static_cast<std::size_t>(BusKind::parallel_8)])
        return BusKind::parallel_8;
    refuse("--bus", "'" + visible(name) + "' is no bus for this: write spi or parallel");
}

struct Flag {
    const char* name;
    const char* help;
};

/// CLI11 would treat a missing flag as false.
void add_choice(CLI::App& app, const Flag& yes, const Flag& no, std::optional<bool>& choice)
{
    CLI::Option* const option = app.add_flag_callback(
        yes.name, [&choice] { choice = true; }, yes.help);
    app.add_flag_callback(
           no.name, [&choice] { choice = false; }, no.help)
        ->excludes(option);
}

void declare_glass_options(CLI::App& app, WiredPanelOptions& options)
{
    const OptionHeading heading{app, option_group::display};
    declare_panel_option(app, options.panel)->required();
    app.add_option_function<std::string>(
           "--glass", [&options](const std::string& text) { options.glass = read_size("--glass", text); },
           "The glass, as it is not turned (default: the usual module's)")
        ->type_name("WxH");
    app.add_option("--column", options.column, "Where the glass begins in the controller's memory")
        ->type_name("N");
    app.add_option("--row", options.row, "Likewise")->type_name("N");
    app.add_option("--rotation", options.degrees, "How far the picture is turned, clockwise")
        ->type_name("DEGREES")
        ->check(one_of({0, 90, 180, 270}));
    add_choice(app, {"--bgr", "Red and blue are swapped on the glass (default: as on the usual module)"},
               {"--rgb", "They are not"}, options.bgr);
    add_choice(app, {"--inverted", "The glass shows colours inverted (likewise)"},
               {"--not-inverted", "It does not"}, options.inverted);
    app.add_option_function<std::string>(
           "--brightness",
           [&options](const std::string& text) {
               options.brightness = read_brightness("--brightness", text);
           },
           "0 to 255, or a share like 40%")
        ->type_name("VALUE");
}

void declare_wire_options(CLI::App& app, WiredPanelOptions& options)
{
    const OptionHeading heading{app, option_group::wires};
    app.add_option_function<std::string>(
           "--bus", [&options](const std::string& name) { options.bus = read_bus(name); },
           "spi, or parallel: eight GPIO lines for data (default: spi)")
        ->type_name("KIND");
    app.add_option("--spi", options.spi, "The SPI device, like /dev/spidev0.0")->type_name("DEVICE");
    app.add_option("--spi-mode", options.spi_mode, "0 or 3 (default: 0)")
        ->type_name("MODE")
        ->check(one_of({0, 3}));
    app.add_option_function<std::string>(
           "--clock", [&options](const std::string& text) { options.clock = read_clock("--clock", text); },
           "Of SPI, like 40MHz (default: what the display is rated for)")
        ->type_name("CLOCK");
    app.add_option(
           "--gpio-chip", options.chip,
           "The chip of the GPIO lines: its path, name or label (default: the one with the first line)")
        ->type_name("CHIP");
    app.add_option_function<std::vector<std::string>>(
           "--pin",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts)
                   read_pin(text, options.lines);
           },
           "Which GPIO line, by name or number, goes to dc, reset, backlight and select of the display, and "
           "with --bus parallel to wr and data0 to data7; may be repeated")
        ->type_name("ROLE=LINE")
        ->allow_extra_args(false);
}

PanelSettings chosen_panel(const WiredPanelOptions& options)
{
    constexpr int quarter = 90;
    PanelSettings panel = options.panel->settings;
    if (options.glass.value_or(panel.glass) != panel.glass) {
        panel.glass = *options.glass;
        panel.column = panel.row = 0;
    }
    panel.column = options.column.value_or(panel.column);
    panel.row = options.row.value_or(panel.row);
    panel.rotation = static_cast<Rotation>(options.degrees / quarter);
    panel.bgr = options.bgr.value_or(panel.bgr);
    panel.inverted = options.inverted.value_or(panel.inverted);
    panel.brightness = options.brightness;
    return panel;
}

void expect_lines(const WiredPanelOptions& options, std::uint32_t needed)
{
    for (std::size_t i = 0; i < line_role_names.size(); ++i) {
        const auto role = static_cast<LineRole>(i);
        const std::string name{line_role_names[i]};
        if ((needed & line_bit(role)) != 0 && !options.lines.contains(role))
            refuse("--pin", "which GPIO line goes to " + name + " of the display? Write --pin " + name +
                                "=LINE, as in --pin " + name + "=GPIO25");
        if ((only_parallel_lines & ~needed & line_bit(role)) != 0 && options.lines.contains(role))
            refuse("--pin", name + " is for --bus parallel");
    }
}

void expect_wires(const WiredPanelOptions& options)
{
    const bool is_spi = options.bus == BusKind::spi;
    if (!is_spi && (!options.spi.empty() || options.clock))
        refuse("--bus", "a parallel display has neither --spi nor --clock");
    if (is_spi && options.spi.empty()) {
        const std::string present = present_spi_devices();
        refuse("--spi",
               "on which SPI device is the display? " +
                   (present.empty() ? "There is none (/dev/spidev*): " + std::string{how_to_enable_spi}
                                    : "There is " + present));
    }
    expect_lines(options, is_spi ? line_bit(LineRole::dc) : parallel_lines);
}

struct DisplayRule {
    SettingsRule rule;
    const char* option;
    const char* hint; ///< null: it is that of a file of settings
};

/// Of config, those that hold for any computer.
constexpr std::array display_rules{
    DisplayRule{bus_not_taken, "--bus", "leave it out: every display here takes SPI"},
    DisplayRule{glass_beyond_memory, "--glass", nullptr},
    DisplayRule{glass_ragged, "--glass", nullptr},
    DisplayRule{rotation_not_done, "--rotation", "write 0 or 180"},
};

void expect_possible(const BoardSettings& settings)
{
    for (const auto& [rule, option, hint] : display_rules)
        if (const auto mistake = rule(settings)) {
            const auto [message, in_settings] = config::text_of(*mistake, settings);
            refuse(option, message + ": " + (hint == nullptr ? in_settings : hint));
        }
}

}

void declare_wired_panel_options(CLI::App& app, WiredPanelOptions& options)
{
    declare_glass_options(app, options);
    declare_wire_options(app, options);
}

BoardSettings chosen_wired_panel(const WiredPanelOptions& options)
{
    constexpr std::uint32_t max_default_clock = 62'500'000; // as on a Pico: wires, not displays, limit it
    BoardSettings settings;
    settings.panel = chosen_panel(options);
    settings.bus = options.bus;
    settings.bus_clock = options.clock.value_or(std::min(config::rated_clock(settings), max_default_clock));
    expect_possible(settings);
    expect_wires(options);
    return settings;
}

}
