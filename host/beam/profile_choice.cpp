#include "host/beam/profile_choice.hpp"

#include "host/beam/beam_reader.hpp"
#include "host/counted.hpp"
#include "host/failure.hpp"
#include "host/input_file.hpp"
#include "host/reported_diagnostics.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace kfast {
namespace {

constexpr InputKind beam_input{"beam", "a .kdl file", "a description begins with 'beam'"};

BeamProfile profile_of(const SourceText& source)
{
    Diagnostics diagnostics;
    const auto profile = read_beam_text(source, diagnostics);
    const std::size_t errors = report(diagnostics, source).errors;
    if (!profile)
        throw Failure(source.name + ": " + counted(errors, "error"));
    return *profile;
}

}

std::span<const ProfileChoice> profile_choices()
{
    static constexpr std::array<ProfileChoice, 3> choices{{
        {"scope", scope_profile},
        {"crt", crt_profile},
        {"galvo", galvo_profile},
    }};
    return choices;
}

const ProfileChoice* profile_named(std::string_view name)
{
    const auto found = std::ranges::find(profile_choices(), name, &ProfileChoice::name);
    return found == profile_choices().end() ? nullptr : &*found;
}

std::vector<std::string_view> profile_names()
{
    std::vector<std::string_view> names;
    std::ranges::transform(profile_choices(), std::back_inserter(names), &ProfileChoice::name);
    return names;
}

BeamProfile chosen_profile(const std::string& name)
{
    if (name.find_first_of("./") != name.npos)
        return profile_of({name, read_input(name, beam_input)});
    if (const ProfileChoice* const choice = profile_named(name))
        return choice->profile;
    throw Failure("there is no beam " + kfast::quoted(name) + ": " + suggestion(name, profile_names()) +
                  ", or name the file that describes it, like my-beam.kdl");
}

}
