#include "host/beam/profile_choice.hpp"

#include "host/beam/beam_text.hpp"
#include "host/file/input_file.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/text/reported_diagnostics.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace kfast {
namespace {

constexpr InputKind beam_input{"beam", "a .kdl file", "a description begins with 'beam'"};

ChosenBeam beam_of(const SourceText& source, std::ostream& out)
{
    Diagnostics diagnostics;
    auto beam = read_beam_text(source, diagnostics);
    const std::size_t errors = report(diagnostics, source, out).errors;
    if (!beam)
        throw Failure(source.name + ": " + counted(errors, "error"));
    beam->file = source.name;
    return *std::move(beam);
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

ChosenBeam chosen_beam(const std::string& name, std::ostream& out)
{
    if (name.find_first_of("./") != name.npos)
        return beam_of({name, read_input(name, beam_input)}, out);
    if (const ProfileChoice* const choice = profile_named(name))
        return {choice->profile, choice->name};
    throw Failure("there is no beam " + in_quotes(name) + ": " + suggestion(name, profile_names()) +
                  ", or name the file that describes it, like my-beam.kdl");
}

}
