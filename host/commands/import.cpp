#include "core/player.hpp"
#include "host/commands/command.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/import/import_report.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/option_values.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/text/progress.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/file/atomic_file.hpp"
#include "host/file/input_file.hpp"
#include "host/program/failure.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <vector>

namespace kfast {
namespace {

namespace fs = std::filesystem;

constexpr double fastest = 1000;
constexpr InputKind import_input{"file to import", "a .json, .lottie, .svg or .sif file", "export it again"};

struct ImportOptions {
    std::string file;
    std::vector<std::string> drawings;
    std::vector<std::string> times;
    std::string output;
    ImportChoice choice;
    bool whole_list = false;
    bool json = false;
    bool quiet = false;

    const std::string& input() const { return drawings.empty() ? file : drawings.front(); }
    bool to_standard_output() const { return output == "-"; }
};

constexpr std::array endings{
    Named<svg::Ending>{"auto", svg::Ending::automatic},
    Named<svg::Ending>{"once", svg::Ending::once},
    Named<svg::Ending>{"repeat", svg::Ending::repeat},
    Named<svg::Ending>{"ping-pong", svg::Ending::ping_pong},
    Named<svg::Ending>{"back", svg::Ending::back_to_first},
};

constexpr std::array layer_keys{
    Named<svg::LayerKeys>{"auto", svg::LayerKeys::automatic},
    Named<svg::LayerKeys>{"always", svg::LayerKeys::always},
    Named<svg::LayerKeys>{"never", svg::LayerKeys::never},
};

std::vector<double> frames_of(const ImportOptions& options)
{
    const double frame_rate = options.choice.options.drawings.frame_rate;
    std::vector<double> frames;
    for (const std::string& text : options.times) {
        const auto time = read_time(text, static_cast<std::uint32_t>(std::lround(frame_rate * 1000)));
        if (!time)
            throw Failure("--at: '" + text + "' is no time: write frames, or seconds like 0.5s");
        frames.push_back(static_cast<double>(time->ticks) / Time::ticks_per_frame);
    }
    return frames;
}

importing::Imported import_drawings(const ImportOptions& options, const importing::Options& choice)
{
    std::vector<SourceText> drawings;
    for (const std::string& file : options.drawings)
        drawings.push_back({file, read_input(file, import_input)});
    return importing::import_key_drawings(std::move(drawings), frames_of(options), choice);
}

importing::Imported import_file(const ImportOptions& options)
{
    WorkBar bar{"importing"};
    importing::Options choice = options.choice.options;
    choice.on_progress = bar.callback();
    if (!options.drawings.empty())
        return import_drawings(options, choice);
    std::string content = read_input(options.file, import_input);
    if (content.starts_with("KFB"))
        throw Failure(options.file + ": a compiled scene already");
    return importing::import_scene(options.file, std::move(content), choice);
}

/// Throws Failure if something is lost that must not be.
void require_all(const ImportOptions& options, const art::Losses& losses)
{
    if (options.choice.on_loss != OnLoss::refuse || losses.empty())
        return;
    const auto length = options.whole_list ? importing::ListLength::whole : importing::ListLength::cut;
    throw Failure(options.input() + ": " + importing::loss_count(losses) + ":\n" +
                  importing::loss_list(losses, length));
}

/// A text that has been changed since it was imported must not be overwritten because of a default name.
fs::path scene_beside(const std::string& input, const std::string& text)
{
    fs::path path = fs::path{input}.replace_extension(".kfast");
    std::error_code none_yet;
    if (!fs::exists(path, none_yet) || fs::equivalent(path, input, none_yet))
        return path;
    std::ifstream file{path, std::ios::binary};
    if (std::string{std::istreambuf_iterator<char>{file}, {}} != text)
        throw Failure(path.string() + ": exists already, and is not the same: -o " + path.string() +
                      " replaces it, or choose another name");
    return path;
}

/// Returns the name for messages.
std::string write_scene(const ImportOptions& options, const std::string& text)
{
    if (options.to_standard_output()) {
        std::cout << text << std::flush;
        return "standard output";
    }
    const fs::path chosen =
        options.output.empty() ? scene_beside(options.input(), text) : fs::path{options.output};
    const fs::path path = output_path(chosen, options.input(), "file that is imported");
    write_file(path, std::as_bytes(std::span{text}));
    return path.string();
}

void print_report(const ImportOptions& options, const std::string& scene, const importing::Imported& imported)
{
    const SceneView view = *SceneView::parse(imported.compiled.bytes);
    const ImportReport report{options.input(),
                              scene,
                              imported,
                              view.canvas(),
                              Player::block_bytes(view, view.canvas()),
                              options.choice.options.size.has_value()};
    const auto length = options.whole_list ? importing::ListLength::whole : importing::ListLength::cut;
    std::ostream& out =
        options.to_standard_output() && !options.quiet ? std::cerr : report_stream(options.quiet);
    out << (options.json ? import_json(report) : import_text(report, length));
}

void run(const ImportOptions& options)
{
    const importing::Imported imported = import_file(options);
    if (options.json && !imported.losses.empty() && options.choice.on_loss == OnLoss::refuse)
        print_report(options, "", imported);
    require_all(options, imported.losses);
    print_report(options, write_scene(options, imported.text), imported);
}

void declare_key_options(CLI::App& app, ImportOptions& options)
{
    const OptionHeading heading{app, option_group::key_drawings};
    svg::KeyOptions& keys = options.choice.options.drawings;
    CLI::Option* const drawings = app.add_option("--keys", options.drawings,
                                                 "Several .svg files, each the same picture at another time")
                                      ->type_name("FILES");
    reads_file(drawings, {".svg"});
    CLI::Option* const times =
        app.add_option("--at", options.times, "When: a frame, or a time like 0.5s, for each of them")
            ->type_name("TIMES");
    drawings->needs(times);
    times->needs(drawings);
    app.add_option("--fps", keys.frame_rate, "Frames per second (default: 30)")
        ->type_name("NUMBER")
        ->check(number_within(1, fastest));
    app.add_option_function<std::string>(
           "--law", [&keys](const std::string& text) { keys.ease = read_ease("--law", text); },
           "How it goes from key to key (default: constant)")
        ->type_name("LAW");
    CLI::Option* const end =
        app.add_option_function<std::string>(
               "--end",
               [&keys](const std::string& name) { keys.ending = named(endings, "--end", name).value; },
               "After the last key: " + names_of(endings) + " (default: auto)")
            ->type_name("HOW");
    CLI::Option* const layers =
        app.add_option_function<std::string>(
               "--layers",
               [&keys](const std::string& name) { keys.layers = named(layer_keys, "--layers", name).value; },
               "Layers named by frames, as keys: " + names_of(layer_keys) + " (default: auto)")
            ->type_name("WHEN");
    offer_names(end, endings);
    offer_names(layers, layer_keys);
}

void require_input(const ImportOptions& options)
{
    if (options.file.empty() == options.drawings.empty())
        throw CLI::RequiredError("one of FILE and --keys FILES --at TIMES");
}

void declare_import(CLI::App& app)
{
    const auto options = std::make_shared<ImportOptions>();
    CLI::Option* const file =
        app.add_option("FILE", options->file,
                       "A file of Lottie (.json, .lottie), SVG (.svg, .svgz) or Synfig (.sif, .sifz)");
    reads_file(file, {".lottie", ".svgz", ".sifz", ".json", ".svg", ".sif"});
    declare_output(app, options->output,
                   "The scene text, - for standard output (default: FILE's name with .kfast)",
                   StandardOutput::is_meant);
    app.add_flag("--all-losses", options->whole_list,
                 "All that is not carried over, however long the list is")
        ->group(option_group::report);
    declare_quiet(app, options->quiet)->excludes(declare_json(app, options->json));
    declare_import_options(app, options->choice);
    declare_key_options(app, *options);
    app.callback([options] {
        require_input(*options);
        run(*options);
    });
}

}

const Command import_command{"import", "Turn a file of Lottie, SVG or Synfig into a scene text",
                             "kfast import eyes.json -o eyes.kfast\n"
                             "  kfast import --keys shut.svg open.svg --at 0 12 -o blink.kfast",
                             declare_import};

}
