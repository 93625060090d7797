#pragma once

#include "host/compile/scene_file.hpp"
#include "host/fit/beam_fit.hpp"
#include "host/fit/fit_report.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// The board that a scene is to fit, as chosen by --board, --panel and --fps.
struct FitOptions {
    std::optional<std::string> board;
    std::optional<fit::Display> panel; ///< instead of the board's
    double frames_per_second = 0;      ///< 0: those of the scene
};

/// Adds --board, and what only means something together with it: --panel and --fps. `options` must outlive
/// the parsing of `app`.
CLI::Option* declare_fit_options(CLI::App& app, FitOptions& options);

/// The board with the panel that was chosen. Throws Failure for an unknown board.
fit::Target chosen_target(const FitOptions& options);

fit::FitReport fit_report(const FitOptions& options, const fit::Target& target, const SceneFile& scene);

/// `target` has a beam.
fit::BeamFit beam_fit(const FitOptions& options, const fit::Target& target, const SceneFile& scene);

/// Why a scene does not fit a board: a line for each reason.
std::string misfit_text(const std::string& file, const fit::Target& target,
                        const std::vector<std::string>& reasons);

/// Throws Failure with all reasons, if there are any.
void require_fit(const std::string& file, const fit::Target& target, const std::vector<std::string>& reasons);
/// Throws Failure with all reasons if `scene` does not fit.
void require_fit(const std::string& file, const FitOptions& options, const fit::Target& target,
                 const SceneFile& scene);

}
