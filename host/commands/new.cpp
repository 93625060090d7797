#include "host/commands/command.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_values.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/templates/scene_templates.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/text/summary.hpp"
#include "host/commands/text/table_lines.hpp"
#include "host/compile/scene_file.hpp"
#include "host/file/atomic_file.hpp"
#include "host/picture/player_source.hpp"
#include "host/preview/terminal/borrowed_terminal.hpp"
#include "host/preview/terminal/half_blocks.hpp"
#include "host/program/failure.hpp"
#include "host/text/reported_diagnostics.hpp"
#include "host/text/visible_output.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string>
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

/// Returns a line for each template with its name and its summary.
std::string template_lines(std::span<const SceneTemplate> templates)
{
    std::vector<TableRow> rows;
    for (const SceneTemplate& one : templates)
        rows.push_back({std::string{one.name}, std::string{one.summary()}});
    return table_text(rows);
}

/// Returns an array of JSON for tools: objects with `name`, `summary`, and the names of `inputs` and `clips`.
/// The text ends with "\n".
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

/// Returns a picture of each template, 18 pixels a side, with its name below: half blocks in the colours of
/// the terminal that standard output is, as many side by side as it is wide. Each picture is that of the
/// time half way through the scene.
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

namespace fs = std::filesystem;

struct NewOptions {
    std::string path;
    std::string_view text = starter_scene;
    bool list = false;
    bool json = false;
    bool force = false;
    bool quiet = false;
};

void require_free(const fs::path& path)
{
    std::error_code ignored;
    if (fs::symlink_status(path, ignored).type() != fs::file_type::not_found)
        throw Failure{path.string() + " exists already; choose another name, or replace it by --force"};
}

void write_scene(const NewOptions& options)
{
    const fs::path path = options.path;
    if (path.empty())
        throw CLI::RequiredError("SCENE");
    if (path.extension() != ".kfast")
        throw Failure{path.string() + ": the name of a scene text ends in .kfast"};
    if (!options.force)
        require_free(path);
    write_file(path, std::as_bytes(std::span{options.text}));
    report_stream(options.quiet) << path.string() << ": a scene to start from; see it with: kfast preview "
                                 << path.string() << '\n';
}

void print_list(bool as_json)
{
    const auto templates = scene_templates();
    if (as_json) {
        std::cout << template_json(templates);
        return;
    }
    if (can_play_in_terminal())
        write_as_is(std::cout, template_pictures(templates));
    std::cout << template_lines(templates);
}

void declare_new(CLI::App& app)
{
    const auto options = std::make_shared<NewOptions>();
    CLI::Option* const path =
        writes_file(app.add_option("SCENE", options->path, "The scene text to write (.kfast)"), {".kfast"});
    CLI::Option* const like = app.add_option_function<std::string>(
        "--like",
        [options](const std::string& name) { options->text = named(scene_templates(), "--like", name).text; },
        "Begin with this scene of the gallery (docs/gallery.md) in place of a first small one");
    offer_names(like->type_name("NAME"), scene_templates());
    CLI::Option* const force = app.add_flag("--force", options->force, "Replace a file of that name");
    CLI::Option* const list =
        app.add_flag("--list", options->list, "Show the scenes of the gallery, in a terminal with pictures");
    list->excludes(path)->excludes(like)->excludes(force);
    declare_json(app, options->json)->needs(list);
    declare_quiet(app, options->quiet);
    app.callback([options] { options->list ? print_list(options->json) : write_scene(*options); });
}

}

const Command new_command{"new", "Write a small scene with comments, to start from",
                          "kfast new eyes.kfast\n"
                          "  kfast new dial.kfast --like gauge\n"
                          "  kfast new --list",
                          declare_new};

}
