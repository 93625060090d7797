#include "host/commands/command.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/info/fit_print.hpp"
#include "host/commands/options/fit_options.hpp"
#include "host/commands/options/output_options.hpp"

#include <iostream>

namespace kfast {
namespace {

struct FitCommandOptions {
    std::string file;
    ImportChoice import_choice;
    FitOptions fit;
    bool json = false;
};

void print_beam_fit(const FitCommandOptions& options, const fit::Target& target, const SceneFile& scene)
{
    const fit::BeamFit report = beam_fit(options.fit, target, scene);
    const BeamFitFacts facts{options.file, target, report};
    std::cout << (options.json ? json_text(facts) : fit_text(facts));
    std::cout.flush(); // before the reasons
    require_fit(options.file, target, report.reasons());
}

void print_fit(const FitCommandOptions& options)
{
    const fit::Target target = chosen_target(options.fit);
    const SceneFile scene = load_scene(options.file, options.import_choice);
    if (target.beam)
        return print_beam_fit(options, target, scene);
    const fit::FitReport report = fit_report(options.fit, target, scene);
    const FitFacts facts{options.file, scene.view, target, report};
    std::cout << (options.json ? json_text(facts) : fit_text(facts));
    std::cout.flush(); // before the reasons
    require_fit(options.file, target, report.reasons());
}

void declare_fit(CLI::App& app)
{
    const auto options = std::make_shared<FitCommandOptions>();
    reads_scene(app.add_option("FILE", options->file, loaded_scene))->required();
    declare_fit_options(app, options->fit)->required();
    declare_import_options(app, options->import_choice);
    declare_json(app, options->json);
    app.callback([options] { print_fit(*options); });
}

}

const Command fit_command{"fit",
                          "Tell whether a scene fits a board, and how fast it plays there",
                          "kfast fit eyes.kfast --board pico\n"
                          "  kfast fit eyes.kfast --board pico --panel ssd1306 --fps 25\n"
                          "  kfast fit eyes.kfast --board my-board.kdl --json",
                          declare_fit,
                          {},
                          board_group};

}
