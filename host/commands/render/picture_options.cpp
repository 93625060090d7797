#include "host/commands/render/picture_options.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/beam/beam_screen_source.hpp"
#include "host/commands/inputs/input_options.hpp"
#include "host/commands/options/beam_options.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/option_values.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/picture/panel_choice.hpp"
#include "host/picture/player_source.hpp"
#include "host/simulator/simulated_board.hpp"
#include "host/sound/deflection.hpp"

#include <array>
#include <string>

namespace kfast {

namespace {

constexpr Size default_size{480, 480};

BeamDisplay chosen_display(const ScreenOptions& options)
{
    BeamDisplay display = display_of(options.beam->base);
    display.spot = options.spot.value_or(display.spot);
    display.half_life = options.half_life.value_or(display.half_life);
    display.phosphor = options.phosphor.value_or(display.phosphor);
    return display;
}

}

CLI::Option* declare_screen_options(CLI::App& app, ScreenOptions& options)
{
    const OptionHeading heading{app, option_group::beam};
    CLI::Option* beam = declare_beam_option(app, options.beam);
    app.add_option("--spot", options.spot, "With --beam: how wide its spot is, in percent of the field")
        ->type_name("PERCENT")
        ->check(number_within(0.05, 10))
        ->needs(beam);
    app.add_option("--decay", options.half_life, "With --beam: milliseconds until half of the light is gone")
        ->type_name("MS")
        ->check(number_within(0.1, 1000))
        ->needs(beam);
    CLI::Option* const phosphor = app.add_option_function<std::string>(
                                         "--phosphor",
                                         [&options](const std::string& name) {
                                             options.phosphor =
                                                 named(phosphor_names(), "--phosphor", name).value;
                                         },
                                         "With --beam: " + names_of(phosphor_names()))
                                      ->type_name("NAME")
                                      ->needs(beam);
    offer_names(phosphor, phosphor_names());
    return beam;
}

std::unique_ptr<FrameSource> open_screen(const ScreenOptions& options, const SceneFile& scene,
                                         std::optional<Size> size)
{
    return std::make_unique<BeamScreenSource>(scene.view, options.beam->profile, chosen_display(options),
                                              screen_size(size));
}

Size screen_size(std::optional<Size> chosen) { return chosen.value_or(default_size); }

namespace {

constexpr std::array fits{
    Named<Fit>{"contain", Fit::contain},
    Named<Fit>{"cover", Fit::cover},
    Named<Fit>{"none", Fit::none},
};

using OnText = std::function<void(const std::string&)>;

CLI::Option* add(CLI::App& app, const char* name, const char* type, const std::string& text,
                 const OnText& set)
{
    const OptionHeading heading{app, option_group::display};
    return app.add_option_function<std::string>(name, set, text)->type_name(type);
}

CLI::Option* add_size(CLI::App& app, PictureOptions& options)
{
    return add(app, "--size", "WxH", "Panel size in pixels (default: the canvas)",
               [&options](const std::string& text) { options.size = read_size("--size", text); });
}

CLI::Option* add_format(CLI::App& app, PictureOptions& options)
{
    CLI::Option* const format =
        add(app, "--format", "NAME", "Pixels: " + names_of(format_names()) + " (default: rgb565)",
            [&options](const std::string& name) {
                options.format = named(format_names(), "--format", name).value;
            });
    return offer_names(format, format_names());
}

CLI::Option* add_scaling(CLI::App& app, PictureOptions& options)
{
    CLI::Option* const fit =
        add(app, "--scaling", "HOW", "Canvas on panel: " + names_of(fits) + " (default: contain)",
            [&options](const std::string& name) { options.fit = named(fits, "--scaling", name).value; });
    return offer_names(fit, fits);
}

}

CLI::Option* declare_panel_option(CLI::App& app, const PanelChoice*& panel)
{
    CLI::Option* const option =
        add(app, "--panel", "NAME", "A known panel: " + names_of(panel_choices()),
            [&panel](const std::string& name) {
                if (const auto hint = fit::undriven_panel_text(name))
                    throw CLI::ValidationError("--panel", "'" + name + "' is unknown: " + *hint);
                panel = &named(panel_choices(), "--panel", name);
            });
    return offer_names(option, panel_choices());
}

void declare_size_options(CLI::App& app, PictureOptions& options)
{
    declare_panel_option(app, options.panel)->excludes(add_size(app, options));
}

void declare_picture_options(CLI::App& app, PictureOptions& options)
{
    declare_size_options(app, options);
    add_scaling(app, options)->excludes(app.get_option("--panel"));
    add_format(app, options)->excludes(app.get_option("--panel"));
    declare_input_options(app, options.inputs);
    declare_drawing_options(app, options.drawings);
}

void declare_seen_options(CLI::App& app, PictureOptions& options)
{
    declare_picture_options(app, options);
    CLI::Option* beam = declare_screen_options(app, options.screen);
    for (const char* const other : {"--panel", "--scaling", "--format"})
        beam->excludes(app.get_option(other));
}

Size panel_size(const PictureOptions& options, const SceneView& scene)
{
    return options.panel != nullptr ? options.panel->settings.size() : options.size.value_or(scene.canvas());
}

Size shown_size(const PictureOptions& options, const SceneView& scene)
{
    return options.screen.beam ? screen_size(options.size) : panel_size(options, scene);
}

PictureOptions drawn_at(PictureOptions options, Size size)
{
    if (options.panel != nullptr)
        options.format = facts_of(options.panel->settings.controller).format;
    options.panel = nullptr;
    options.size = size;
    return options;
}

void apply_inputs(const PictureOptions& options, const SceneFile& scene, InputReceiver& source)
{
    put_values(chosen_values(options.inputs, options.drawings, scene.view), scene.view, source);
}

std::unique_ptr<FrameSource> open_at_rest(const PictureOptions& options, const SceneFile& scene)
{
    if (options.screen.beam)
        return open_screen(options.screen, scene, options.size);
    if (options.panel != nullptr)
        return open_board_source(scene.bytes, options.panel->settings);
    const Size size = panel_size(options, scene.view);
    return std::make_unique<PlayerSource>(scene.view, size, options.fit,
                                          options.format.value_or(PixelFormat::rgb565));
}

std::unique_ptr<FrameSource> open_source(const PictureOptions& options, const SceneFile& scene)
{
    auto source = open_at_rest(options, scene);
    apply_inputs(options, scene, *source);
    return source;
}

BeamProfile sound_beam(const std::optional<BeamProfile>& chosen, std::uint32_t rate)
{
    BeamProfile profile = chosen.value_or(sound_profile);
    profile.rate = rate;
    return profile;
}

BeamSource open_beam(const BeamProfile& profile, std::uint32_t budget, const PictureOptions& inputs,
                     const SceneFile& scene)
{
    BeamSource source{scene.view, profile, budget};
    apply_inputs(inputs, scene, source);
    return source;
}

}
