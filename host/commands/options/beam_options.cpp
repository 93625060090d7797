#include "host/commands/options/beam_options.hpp"

#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"

#include <functional>
#include <string>

namespace kfast {

namespace {

CLI::Option* add(CLI::App& app, const std::function<void(const ChosenBeam&)>& set)
{
    const OptionHeading heading{app, option_group::beam};
    CLI::Option* const beam =
        app.add_option_function<std::string>(
               "--beam", [set](const std::string& name) { set(chosen_beam(name)); },
               "For a vector display: scope, crt, galvo, or a file that describes one, FILE.kdl")
            ->type_name("PROFILE");
    return offer(reads_file(beam), profile_names());
}

}

CLI::Option* declare_beam_option(CLI::App& app, std::optional<BeamProfile>& beam)
{
    return add(app, [&beam](const ChosenBeam& chosen) { beam = chosen.profile; });
}

CLI::Option* declare_beam_option(CLI::App& app, std::optional<ChosenBeam>& beam)
{
    return add(app, [&beam](const ChosenBeam& chosen) { beam = chosen; });
}

namespace {

CLI::Option* add_invert(CLI::App& app, Deflection& deflection)
{
    return app
        .add_option_function<std::string>(
            "--mirror",
            [&deflection](const std::string& which) {
                deflection.inverts_x = which != "y";
                deflection.inverts_y = which != "x";
            },
            "What is upside down or mirrored on the screen")
        ->type_name("AXIS")
        ->check(one_of({"x", "y", "both"}));
}

}

std::vector<CLI::Option*> declare_sound_options(CLI::App& app, SoundOptions& options)
{
    const OptionHeading heading{app, option_group::sound};
    CLI::Option* rate = app.add_option("--sample-rate", options.rate, "Samples in a second (default: 48000)")
                            ->type_name("HZ")
                            ->check(number_within(8'000, 768'000));
    CLI::Option* swap =
        app.add_flag("--swap", options.deflection.is_swapped, "x to the right channel, y to the left one");
    CLI::Option* gain = app.add_option("--gain", options.deflection.gain,
                                       "1: the picture takes all that the sound card puts out (default: 1)")
                            ->type_name("FACTOR")
                            ->check(number_within(0.001, 16));
    return {rate, swap, add_invert(app, options.deflection), gain};
}

}
