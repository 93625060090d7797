#include "host/commands/options/fit_options.hpp"

#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/option_values.hpp"
#include "host/commands/text/progress.hpp"
#include "host/fit/beam_fit.hpp"
#include "host/fit/board_choice.hpp"
#include "host/fit/board_texts.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/program/failure.hpp"

namespace kfast {
namespace {

constexpr double max_fps = 1000;

fit::Display panel_named(const std::string& name)
{
    if (const fit::Display* const display = fit::display_named(name))
        return *display;
    const std::string hint = fit::other_panel_text(name).value_or(fit::display_suggestion(name) +
                                                                  "; others are described with the board");
    throw CLI::ValidationError("--panel", "'" + name + "' is unknown: " + hint);
}

}

CLI::Option* declare_fit_options(CLI::App& app, FitOptions& options)
{
    const OptionHeading heading{app, option_group::board};
    CLI::Option* const board = app.add_option("--board", options.board,
                                              "A known board (" + names_of(fit::board_texts()) +
                                                  "), or the file that describes yours (docs/fit.md)")
                                   ->type_name("NAME");
    offer_names(board, fit::board_texts());
    CLI::Option* const panel =
        app.add_option_function<std::string>(
               "--panel", [&options](const std::string& name) { options.panel = panel_named(name); },
               "Another panel than the board's: " + names_of(fit::displays()))
            ->type_name("NAME")
            ->needs(board);
    offer(panel, fit::display_names());
    app.add_option("--fps", options.frames_per_second,
                   "Frames per second to be reached (default: the scene's)")
        ->type_name("NUMBER")
        ->check(number_within(1, max_fps))
        ->needs(board);
    return board;
}

fit::Target chosen_target(const FitOptions& options)
{
    fit::Target target = fit::chosen_board(*options.board);
    if (options.panel && target.beam)
        throw Failure("--panel: the board " + target.name + " has a beam, not a panel");
    if (options.panel)
        target.display = *options.panel;
    return target;
}

fit::FitReport fit_report(const FitOptions& options, const fit::Target& target, const SceneFile& scene)
{
    WorkBar bar{"measuring"};
    return fit::fit_report({.scene = scene.view,
                            .item_names = scene.item_names,
                            .target = target,
                            .frames_per_second = options.frames_per_second,
                            .on_progress = bar.callback()});
}

fit::BeamFit beam_fit(const FitOptions& options, const fit::Target& target, const SceneFile& scene)
{
    WorkBar bar{"measuring"};
    return fit::beam_fit(scene.view, target, options.frames_per_second, {}, bar.callback());
}

std::string misfit_text(const std::string& file, const fit::Target& target,
                        const std::vector<std::string>& reasons)
{
    std::string text = file + ": does not fit " + target.name;
    for (const std::string& reason : reasons)
        text += "\n  " + reason;
    return text;
}

void require_fit(const std::string& file, const fit::Target& target, const std::vector<std::string>& reasons)
{
    if (!reasons.empty())
        throw Failure(misfit_text(file, target, reasons));
}

void require_fit(const std::string& file, const FitOptions& options, const fit::Target& target,
                 const SceneFile& scene)
{
    require_fit(file, target,
                target.beam ? beam_fit(options, target, scene).reasons()
                            : fit_report(options, target, scene).reasons());
}

}
