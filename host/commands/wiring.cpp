#include "host/config/wiring.hpp"
#include "host/commands/command.hpp"
#include "host/commands/offered_names.hpp"
#include "host/commands/report_options.hpp"
#include "host/config/config_input.hpp"
#include "host/config/configurations.hpp"
#include "host/config/firmware_images.hpp"
#include "host/config/pico_drawing.hpp"
#include "host/config/pico_edge.hpp"
#include "host/config/setting_words.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <nlohmann/json.hpp>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

struct WiringOptions {
    std::string input;
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
    return json.dump(2) + '\n';
}

using Cells = std::array<std::string, 5>;

Cells cells_of(const config::Connection& wire)
{
    return {wire.end, config::edge_name(wire.pin), "pin " + std::to_string(wire.pin),
            std::string{config::edge_side(wire.pin)}, wire.purpose};
}

using Widths = std::array<std::size_t, std::tuple_size_v<Cells>>;

Widths widths_of(std::span<const config::Connection> wires)
{
    Widths widths{};
    for (const config::Connection& wire : wires) {
        const Cells cells = cells_of(wire);
        for (std::size_t i = 0; i < cells.size(); ++i)
            widths[i] = std::max(widths[i], cells[i].size());
    }
    return widths;
}

std::string row_text(const Cells& cells, const Widths& widths)
{
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i)
        text += "  " + cells[i] + std::string(widths[i] - cells[i].size(), ' ');
    return text.erase(text.find_last_not_of(' ') + 1) + '\n';
}

std::string table(std::span<const config::Connection> wires)
{
    const Widths widths = widths_of(wires);
    std::string text;
    std::string part;
    for (const config::Connection& wire : wires) {
        if (wire.part != part)
            text += '\n' + wire.part + '\n';
        part = wire.part;
        text += row_text(cells_of(wire), widths);
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

std::string plain_text(const WiringOptions& options, std::span<const config::Connection> wires,
                       const BoardSettings& settings)
{
    return options.input + ": " + display_text(settings) + "\nfirmware: " + config::image_of(settings.bus) +
           "\n" + table(wires) + outputs_text(settings) + "\nThe Pico from above\n\n" +
           config::pico_drawing(wires);
}

void print_wiring(const WiringOptions& options)
{
    const BoardSettings settings = config::chosen_settings(options.input);
    const std::vector<config::Connection> wires = config::wiring(settings);
    std::cout << (options.json ? json_text(settings, wires) : plain_text(options, wires, settings));
}

void declare_wiring(CLI::App& app)
{
    const auto options = std::make_shared<WiringOptions>();
    CLI::Option* const input =
        app.add_option("INPUT", options->input,
                       "A ready configuration, or a .kdl, .bin or .uf2 file that holds one (docs/config.md)")
            ->required();
    offer_names(input, config::configurations());
    declare_json(app, options->json);
    app.callback([options] { print_wiring(*options); });
}

}

const Command wiring_command{"wiring",
                             "Tell which pin of the board goes to which pin of the display",
                             "kfast wiring pico-st7789",
                             declare_wiring,
                             {},
                             settings_group};

}
