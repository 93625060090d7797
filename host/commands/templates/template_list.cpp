#include "host/commands/templates/template_list.hpp"

#include "host/commands/text/clip_names.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/text/table_lines.hpp"
#include "host/compile/scene_file.hpp"
#include "host/picture/player_source.hpp"
#include "host/preview/terminal/borrowed_terminal.hpp"
#include "host/preview/terminal/half_blocks.hpp"
#include "host/preview/terminal/terminal_colours.hpp"
#include "host/text/reported_diagnostics.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace kfast {
namespace {

constexpr int thumbnail_side = 18; ///< in characters, and in pixels
constexpr int thumbnail_gap = 2;

using Thumbnail = std::vector<std::string>; ///< lines

SceneFile scene_of_template(const SceneTemplate& one)
{
    return scene_of(std::string{one.name} + ".kfast", std::string{one.text}, {}, printing_to(std::cerr),
                    std::cerr);
}

std::vector<std::string_view> all_input_names(const SceneView& scene)
{
    std::vector<std::string_view> names;
    for (InputCursor cursor = scene.inputs(); !cursor.at_end();)
        names.push_back(cursor.next().name);
    return names;
}

std::string padded(std::string_view text, std::size_t width)
{
    std::string line{text};
    line.resize(std::max(width, text.size()), ' ');
    return line;
}

/// The picture, and the name under it.
Thumbnail thumbnail(const SceneTemplate& one, TerminalColours colours)
{
    const SceneFile scene = scene_of_template(one);
    PlayerSource source{scene.view, {thumbnail_side, thumbnail_side}, Fit::contain, PixelFormat::rgb565};
    const Time middle{scene.view.length().ticks / 2};
    std::istringstream text{
        half_blocks(widen(source.show(middle)), {thumbnail_side, thumbnail_side / 2}, colours)};
    Thumbnail lines;
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    lines.push_back(padded(one.name, thumbnail_side));
    return lines;
}

/// Pictures of the same height, one beside the other.
std::string side_by_side(std::span<const Thumbnail> pictures)
{
    std::string text;
    for (std::size_t line = 0; line < pictures.front().size(); ++line) {
        for (const Thumbnail& picture : pictures)
            text += picture[line] + std::string(thumbnail_gap, ' ');
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text + '\n';
}

}

std::string template_lines(std::span<const SceneTemplate> templates)
{
    std::vector<TableRow> rows;
    for (const SceneTemplate& one : templates)
        rows.push_back({std::string{one.name}, std::string{one.summary()}});
    return table_text(rows);
}

std::string template_json(std::span<const SceneTemplate> templates)
{
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const SceneTemplate& one : templates) {
        const SceneFile scene = scene_of_template(one);
        json.push_back({{"name", one.name},
                        {"summary", one.summary()},
                        {"inputs", all_input_names(scene.view)},
                        {"clips", clip_names(scene.view)}});
    }
    return json_text(json);
}

std::string template_pictures(std::span<const SceneTemplate> templates)
{
    const int room = terminal_size().width + thumbnail_gap;
    const auto columns = static_cast<std::size_t>(std::max(1, room / (thumbnail_side + thumbnail_gap)));
    std::vector<Thumbnail> pictures;
    for (const SceneTemplate& one : templates)
        pictures.push_back(thumbnail(one, terminal_colours()));
    std::string text;
    for (std::span<const Thumbnail> rest{pictures}; !rest.empty();) {
        const std::span<const Thumbnail> row = rest.first(std::min(columns, rest.size()));
        text += side_by_side(row);
        rest = rest.subspan(row.size());
    }
    return text;
}

}
