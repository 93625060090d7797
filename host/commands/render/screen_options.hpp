#pragma once

#include "host/beam/phosphor.hpp"
#include "host/beam/profile_choice.hpp"
#include "host/compile/scene_file.hpp"
#include "host/picture/frame_source.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

namespace kfast {

/// What the screen of a vector display is like, as chosen by --beam, --spot, --decay and --phosphor.
struct ScreenOptions {
    std::optional<ChosenBeam> beam; ///< none: no vector display
    std::optional<double> spot;     ///< as in BeamDisplay; none of these: the profile's own display
    std::optional<double> half_life;
    std::optional<Phosphor> phosphor;
};

/// Adds all of them and returns --beam. `options` must outlive the parsing.
CLI::Option* declare_screen_options(CLI::App& app, ScreenOptions& options);

/// Of the picture, if this one was chosen.
Size screen_size(std::optional<Size> chosen);

/// `options` has a beam, and `scene` must outlive the source.
std::unique_ptr<FrameSource> open_screen(const ScreenOptions& options, const SceneFile& scene,
                                         std::optional<Size> size);

}
