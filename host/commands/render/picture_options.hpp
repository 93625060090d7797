#pragma once

#include "core/beam/beam_profile.hpp"
#include "core/player.hpp"
#include "host/beam/beam_source.hpp"
#include "host/beam/phosphor.hpp"
#include "host/beam/profile_choice.hpp"
#include "host/commands/inputs/input_options.hpp"
#include "host/compile/scene_file.hpp"
#include "host/picture/frame_source.hpp"
#include "host/picture/panel_choice.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
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

/// The size of the picture, if this one was chosen.
Size screen_size(std::optional<Size> chosen);

/// `options` has a beam, and `scene` must outlive the source.
std::unique_ptr<FrameSource> open_screen(const ScreenOptions& options, const SceneFile& scene,
                                         std::optional<Size> size);

/// What a scene is drawn on, as chosen by --size, --scaling, --format, --panel and --beam, and what its
/// inputs are set to.
struct PictureOptions {
    std::optional<Size> size; ///< none: the canvas of the scene
    Fit fit = Fit::contain;
    std::optional<PixelFormat> format = {}; ///< none: rgb565
    const PanelChoice* panel = nullptr;     ///< instead of size, fit and format: it is driven as on a board
    ScreenOptions screen = {};              ///< with a beam instead of fit, format and panel
    InputOptions inputs = {};
    DrawingOptions drawings = {};
};

/// Adds these options to `app`, but not --beam. `options` must outlive its parsing.
void declare_picture_options(CLI::App& app, PictureOptions& options);

/// Adds all of them, for pictures that are looked at.
void declare_seen_options(CLI::App& app, PictureOptions& options);

/// Adds --panel only. `panel` must outlive the parsing.
CLI::Option* declare_panel_option(CLI::App& app, const PanelChoice*& panel);

/// Adds --size and --panel only.
void declare_size_options(CLI::App& app, PictureOptions& options);

Size panel_size(const PictureOptions& options, const SceneView& scene);
/// The size of the pictures that open_source() makes.
Size shown_size(const PictureOptions& options, const SceneView& scene);
/// The same display with another size: of a known panel, its pixels alone are left.
PictureOptions drawn_at(PictureOptions options, Size size);

/// Applies what is chosen. Throws what chosen_values() and put_values() throw.
void apply_inputs(const PictureOptions& options, const SceneFile& scene, InputReceiver& source);

/// Its inputs have their default values. `scene` must outlive the source.
std::unique_ptr<FrameSource> open_at_rest(const PictureOptions& options, const SceneFile& scene);
/// With the inputs as chosen. `scene` must outlive the source.
std::unique_ptr<FrameSource> open_source(const PictureOptions& options, const SceneFile& scene);

/// The profile that was chosen, else that of sound, with as many points in a second as the sound has samples.
BeamProfile sound_beam(const std::optional<BeamProfile>& chosen, std::uint32_t rate);

/// The points of the scene's pictures, with the inputs as chosen. `scene` must outlive it.
BeamSource open_beam(const BeamProfile& profile, std::uint32_t budget, const PictureOptions& inputs,
                     const SceneFile& scene);

}
