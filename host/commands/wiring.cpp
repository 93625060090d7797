#include "host/config/wiring.hpp"
#include "host/commands/command.hpp"
#include "host/commands/flash/settings_choice.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/text/table_lines.hpp"
#include "host/config/configurations.hpp"
#include "host/config/firmware_images.hpp"
#include "host/config/pico_pins.hpp"
#include "host/config/setting_words.hpp"

#include <iostream>
#include <optional>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

struct WiringOptions {
    SettingsOptions settings; ///< of a configuration, with other pins
    bool json = false;
};

Json json_of(const config::Connection& wire)
{
    return {{"part", wire.part},
            {"end", wire.end},
            {"gpio", wire.gpio ? Json(*wire.gpio) : Json(nullptr)},
            {"name", config::edge_name(wire.pin)},
            {"pin", wire.pin},
            {"side", config::edge_side(wire.pin)},
            {"purpose", wire.purpose}};
}

/// What is at the other end, and its name there.
std::pair<const char*, Json> display_json(const BoardSettings& settings)
{
    if (leads_beam(settings.bus))
        return {"beam", {{"rate", settings.beam.rate}, {"laser", settings.beam.is_laser}}};
    const Size size = settings.panel.size();
    return {"panel",
            {{"name", config::word_of(settings.panel.controller)},
             {"width", size.width},
             {"height", size.height}}};
}

std::string json_text(const BoardSettings& settings, std::span<const config::Connection> wires)
{
    Json connections = Json::array();
    for (const config::Connection& wire : wires)
        connections.push_back(json_of(wire));
    const Json json{{"board", "pico"},
                    display_json(settings),
                    {"bus", config::word_of(settings.bus)},
                    {"firmware", config::image_of(settings.bus)},
                    {"connections", connections}};
    return kfast::json_text(json);
}

TableRow cells_of(const config::Connection& wire)
{
    return {wire.end, config::edge_name(wire.pin), "pin " + std::to_string(wire.pin),
            std::string{config::edge_side(wire.pin)}, wire.purpose};
}

std::string table(std::span<const config::Connection> wires)
{
    std::vector<TableRow> rows;
    for (const config::Connection& wire : wires)
        rows.push_back(cells_of(wire));
    const std::vector<std::string> lines = table_lines(rows, "  ");
    std::string text;
    std::string part;
    for (std::size_t number = 0; number < wires.size(); ++number) {
        if (wires[number].part != part)
            text += '\n' + wires[number].part + '\n';
        part = wires[number].part;
        text += lines[number] + '\n';
    }
    return text;
}

std::string display_text(const BoardSettings& settings)
{
    const std::string text = config::display_text(settings) + " by " + config::word_of(settings.bus);
    if (leads_beam(settings.bus))
        return text + ", " + std::to_string(settings.beam.rate) + " points a second";
    return text + ", picture " + config::size_text(settings.panel.size());
}

/// What does not come from the Pico.
std::string outputs_text(const BoardSettings& settings)
{
    if (!leads_beam(settings.bus))
        return {};
    std::string text = "\nfrom the converters to the display, 0 to 3.3 V\n";
    for (const auto& [end, axis] : config::converter_outputs)
        text += "  " + std::string{end} + "  " + std::string{axis} + '\n';
    return text;
}

/// Many modules with an ST7789 have seven pins, and no CS among them.
std::string hint_text(const BoardSettings& settings)
{
    if (settings.bus != BusKind::spi || settings.pin(PinRole::select) == no_pin)
        return {};
    return "\nNo CS on your module? --pin select=none, here and with 'kfast flash': the Pico drives SPI in "
           "mode 3, as\n"
           "displays without CS want it\n";
}

std::string plain_text(const std::string& name, std::span<const config::Connection> wires,
                       const BoardSettings& settings)
{
    return name + ": " + display_text(settings) + "\nfirmware: " + config::image_of(settings.bus) + "\n" +
           table(wires) + hint_text(settings) + outputs_text(settings) + "\nThe Pico from above\n\n" +
           config::pico_drawing(wires);
}

void print_wiring(const WiringOptions& options)
{
    if (options.settings.config.empty())
        throw CLI::RequiredError("INPUT");
    const NamedSettings chosen = *SettingsChoice{options.settings}.on(std::nullopt);
    const std::vector<config::Connection> wires = config::wiring(chosen.settings);
    std::cout << (options.json ? json_text(chosen.settings, wires)
                               : plain_text(chosen.name, wires, chosen.settings));
}

void declare_wiring(CLI::App& app)
{
    const auto options = std::make_shared<WiringOptions>();
    CLI::Option* const input =
        app.add_option("INPUT", options->settings.config,
                       "A ready configuration, or a .kdl, .bin or .uf2 file that holds one (docs/config.md)")
            ->required();
    offer_names(reads_file(input, {".kdl", ".bin", ".uf2"}), config::configurations());
    declare_pin_option(app, options->settings.pins);
    declare_json(app, options->json);
    app.callback([options] { print_wiring(*options); });
}

}

const Command wiring_command{"wiring",
                             "Tell which pin of the board goes to which pin of the display",
                             "kfast wiring pico-st7789\n"
                             "  kfast wiring pico-st7789 --pin select=none",
                             declare_wiring,
                             {},
                             board_group};

}
