#include "host/commands/command.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/fit_options.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/text/summary.hpp"
#include "host/compile/scene_file.hpp"
#include "host/file/atomic_file.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iostream>
#include <string_view>

namespace kfast {
namespace {

namespace fs = std::filesystem;

struct CompileOptions {
    std::string scene;
    std::string output;
    ImportChoice import_choice;
    FitOptions fit;
    bool quiet = false;
};

/// The files that other commands make from a scene.
struct OtherOutput {
    std::string_view endings;
    std::string_view hint;
};

constexpr std::array other_outputs{
    OtherOutput{" .h .hh .hpp .hxx .inc .c .cc .cpp .cxx ", "for a header: kfast export --header"},
    OtherOutput{" .png .apng .gif .svg .mp4 .webm ", "for pictures: kfast render"},
    OtherOutput{" .uf2 ", "for the drive of a Pico: kfast uf2 pack --scene"},
    OtherOutput{" .ild ", "for an ILDA file: kfast export --ild"},
    OtherOutput{" .wav ", "for a sound: kfast export --wav"},
};

/// With another ending nothing would recognize the file as a compiled scene.
void require_scene_name(const CompileOptions& options)
{
    std::string ending = ' ' + fs::path{options.output}.extension().string() + ' ';
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    for (const auto& [endings, hint] : other_outputs)
        if (ending.size() > 2 && endings.find(ending) != endings.npos)
            throw CLI::ValidationError("--output", "'" + options.output + "': a compiled scene is a .kfb; " +
                                                       std::string{hint} + ' ' + options.scene + " -o " +
                                                       options.output);
}

fs::path chosen_output(const CompileOptions& options)
{
    return options.output.empty() ? fs::path{options.scene}.replace_extension(".kfb")
                                  : fs::path{options.output};
}

void check_fit(const CompileOptions& options, const SceneFile& scene)
{
    if (!options.fit.board)
        return;
    const fit::Target target = chosen_target(options.fit);
    require_fit(options.scene, options.fit, target, scene);
}

void compile_scene(const CompileOptions& options)
{
    require_scene_name(options);
    const SceneFile scene = load_scene(options.scene, options.import_choice);
    if (!scene.was_text)
        throw Failure(options.scene + ": compiled already: name the .kfast file it was made from");
    check_fit(options, scene);
    const fs::path output = output_path(chosen_output(options), options.scene);
    write_file(output, scene.bytes);
    report_stream(options.quiet) << output.string() << ": " << summary(scene) << '\n';
}

void declare_compile(CLI::App& app)
{
    const auto options = std::make_shared<CompileOptions>();
    CLI::Option* const scene =
        app.add_option("SCENE", options->scene,
                       "The scene text (.kfast), or a file to import (.json, .lottie, .svg, .sif)")
            ->required();
    reads_file(scene, {".lottie", ".svg", ".sif", ".kfast", ".json"});
    declare_output(app, options->output, "The compiled scene (default: SCENE's name with .kfb)");
    declare_import_options(app, options->import_choice);
    declare_fit_options(app, options->fit);
    declare_quiet(app, options->quiet);
    app.callback([options] { compile_scene(*options); });
}

}

const Command compile_command{"compile",
                              "Turn a scene text into the .kfb file a board plays",
                              "kfast compile eyes.kfast -o eyes.kfb\n"
                              "  kfast compile eyes.json --strict",
                              declare_compile,
                              {},
                              board_group};

}
