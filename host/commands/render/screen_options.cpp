#include "host/commands/render/screen_options.hpp"

#include "host/beam/beam_screen_source.hpp"
#include "host/commands/options/beam_option.hpp"
#include "host/commands/options/named_choice.hpp"
#include "host/commands/options/number_range.hpp"
#include "host/commands/options/offered_names.hpp"
#include "host/commands/options/option_groups.hpp"

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

}
