#include "host/commands/render/picture_options.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/commands/inputs/input_values.hpp"
#include "host/commands/options/named_choice.hpp"
#include "host/commands/options/offered_names.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/text/size_text.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/picture/format_name.hpp"
#include "host/picture/player_source.hpp"
#include "host/simulator/board_source.hpp"

#include <array>
#include <string>

namespace kfast {
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

}
