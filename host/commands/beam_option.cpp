#include "host/commands/beam_option.hpp"

#include "host/beam/profile_choice.hpp"

namespace kfast {

CLI::Option* declare_beam_option(CLI::App& app, std::optional<BeamProfile>& beam)
{
    return app
        .add_option_function<std::string>(
            "--beam", [&beam](const std::string& name) { beam = chosen_profile(name); },
            "For a vector display: scope, crt, galvo, or a file that describes one, FILE.kdl")
        ->type_name("PROFILE");
}

}
