#include "host/commands/command.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/commands/panel_list.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/text/size_text.hpp"
#include "host/commands/text/table_lines.hpp"
#include "host/picture/format_name.hpp"

#include <iostream>
#include <memory>
#include <utility>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

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
