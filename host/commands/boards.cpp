#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"
#include "firmware/settings/controller_facts.hpp"
#include "host/commands/command.hpp"
#include "host/commands/flash/settings_choice.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/commands/text/table_lines.hpp"
#include "host/config/setting_words.hpp"
#include "host/fit/board_choice.hpp"
#include "host/fit/board_reader.hpp"
#include "host/fit/board_texts.hpp"
#include "host/fit/display.hpp"
#include "host/fit/wording.hpp"
#include "host/picture/panel_choice.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

namespace {

/// A panel that some command knows by its name.
struct ListedPanel {
    std::string name;
    Size size;
    PixelFormat format;
    std::string bus;         ///< "spi, parallel"
    bool is_drawn = false;   ///< by --panel of render, preview and others that draw, and of kfast panel
    bool is_fitted = false;  ///< by kfast fit --panel
    bool is_flashed = false; ///< by kfast flash --panel
};

std::string buses_of(const ControllerFacts& facts)
{
    std::string buses;
    for (const BusKind bus : {BusKind::spi, BusKind::parallel_8, BusKind::i2c})
        if (facts.takes(bus))
            buses.append(buses.empty() ? "" : ", ").append(config::word_of(bus));
    return buses;
}

/// What the driver of this name reports; fit has displays without a driver.
ListedPanel panel_called(std::string_view name)
{
    const auto choices = panel_choices();
    const auto choice = std::ranges::find(choices, name, &PanelChoice::name);
    if (choice != choices.end()) {
        const ControllerFacts& facts = facts_of(choice->settings.controller);
        return {.name = std::string{name},
                .size = choice->settings.size(),
                .format = facts.format,
                .bus = buses_of(facts),
                .is_drawn = true};
    }
    const fit::Display& display = *fit::display_named(name);
    return {.name = std::string{name}, .size = display.size, .format = display.format, .bus = "spi"};
}

/// "ili9341-parallel" is no controller.
ListedPanel panel_of_settings(const std::string& name)
{
    const BoardSettings settings = ready_settings(name);
    return {.name = name,
            .size = settings.panel.size(),
            .format = facts_of(settings.panel.controller).format,
            .bus = config::word_of(settings.bus),
            .is_flashed = true};
}

/// What pixels of this format can show: "65536 colours", "16 greys", "black and white".
std::string colours_text(PixelFormat format)
{
    const int bits = bits_per_pixel(format);
    if (bits == 1)
        return "black and white";
    const std::string count = std::to_string(1 << bits);
    return count + (format == PixelFormat::grey4 ? " greys" : " colours");
}

/// All panels that some command knows, by name.
std::vector<ListedPanel> listed_panels()
{
    std::vector<ListedPanel> panels;
    for (const std::string_view name : fit::display_names()) {
        panels.push_back(panel_called(name));
        panels.back().is_fitted = true;
    }
    for (const std::string_view name : ready_panels()) {
        const auto same = std::ranges::find(panels, name, &ListedPanel::name);
        if (same == panels.end())
            panels.push_back(panel_of_settings(std::string{name}));
        else
            same->is_flashed = true;
    }
    std::ranges::sort(panels, {}, &ListedPanel::name);
    return panels;
}

using Json = nlohmann::ordered_json;

std::vector<fit::Target> all_boards()
{
    std::vector<fit::Target> boards;
    for (const fit::BoardText& board : fit::board_texts())
        boards.push_back(fit::chosen_board(std::string{board.name}));
    return boards;
}

std::string shown_on(const fit::Target& board)
{
    if (board.beam)
        return "a beam, " + std::to_string(board.beam->rate) + " points a second";
    return std::string{board.display.name} + ' ' + size_text(board.display.size) + ", " +
           colours_text(board.display.format);
}

TableRow row_of(const fit::Target& board)
{
    return {board.name,
            board.processor_name + ", " + fit::frequency_text(board.clock),
            fit::memory_text(board.flash),
            fit::memory_text(board.ram),
            std::string{fit::word_of(board.bus.kind)} + ", " + fit::frequency_text(board.bus.clock),
            shown_on(board)};
}

Json json_of(const fit::Target& board)
{
    Json json{{"name", board.name},
              {"processor", board.processor_name},
              {"clock", board.clock},
              {"flash", board.flash},
              {"ram", board.ram},
              {"bus", {{"kind", fit::word_of(board.bus.kind)}, {"clock", board.bus.clock}}}};
    if (board.beam)
        json["beam"] = {{"rate", board.beam->rate}};
    else
        json["panel"] = {{"name", board.display.name},
                         {"width", board.display.size.width},
                         {"height", board.display.size.height},
                         {"format", name_of(board.display.format)}};
    return json;
}

void print_boards(bool is_json)
{
    std::vector<TableRow> rows{{"BOARD", "PROCESSOR", "FLASH", "RAM", "BUS", "DISPLAY"}};
    Json json = Json::array();
    for (const fit::Target& board : all_boards()) {
        rows.push_back(row_of(board));
        json.push_back(json_of(board));
    }
    std::cout << (is_json ? json_text(json) : table_text(rows));
}

void declare_boards(CLI::App& app)
{
    const auto json = std::make_shared<bool>(false);
    declare_json(app, *json);
    app.callback([json] { print_boards(*json); });
}

}

const Command boards_command{
    "boards",   "List the boards that 'kfast fit --board' knows", "kfast boards", declare_boards, {},
    board_group};

namespace {

std::string known_to(const ListedPanel& panel)
{
    std::string commands;
    for (const auto& [is_known, name] :
         {std::pair{panel.is_drawn, "render, preview, panel"}, std::pair{panel.is_fitted, "fit"},
          std::pair{panel.is_flashed, "flash"}})
        if (is_known)
            commands.append(commands.empty() ? "" : ", ").append(name);
    return commands;
}

Json json_of(const ListedPanel& panel)
{
    return {{"name", panel.name},
            {"width", panel.size.width},
            {"height", panel.size.height},
            {"format", name_of(panel.format)},
            {"bus", panel.bus},
            {"draw", panel.is_drawn},
            {"fit", panel.is_fitted},
            {"flash", panel.is_flashed}};
}

void print_panels(bool is_json)
{
    std::vector<TableRow> rows{{"PANEL", "SIZE", "COLOURS", "BUS", "FOR --panel OF"}};
    Json json = Json::array();
    for (const ListedPanel& panel : listed_panels()) {
        rows.push_back(
            {panel.name, size_text(panel.size), colours_text(panel.format), panel.bus, known_to(panel)});
        json.push_back(json_of(panel));
    }
    std::cout << (is_json ? json_text(json) : table_text(rows));
}

void declare_panels(CLI::App& app)
{
    const auto json = std::make_shared<bool>(false);
    declare_json(app, *json);
    app.callback([json] { print_panels(*json); });
}

}

const Command panels_command{
    "panels", "List the panels that options --panel know", "kfast panels", declare_panels, {}, board_group};

}
