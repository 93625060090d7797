#include "host/commands/options/beam_option.hpp"
#include "host/commands/options/offered_names.hpp"
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
    return offer(beam, profile_names());
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

}
