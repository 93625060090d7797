#include "host/commands/command.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/commands/panel_list.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/text/size_text.hpp"
#include "host/commands/text/table_lines.hpp"
#include "host/fit/board_choice.hpp"
#include "host/fit/board_reader.hpp"
#include "host/fit/board_texts.hpp"
#include "host/fit/wording.hpp"
#include "host/picture/format_name.hpp"

#include <iostream>
#include <memory>

namespace kfast {
namespace {

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

}
