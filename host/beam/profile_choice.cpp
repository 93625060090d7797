#include "host/beam/profile_choice.hpp"

#include "host/failure.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace kfast {

std::span<const ProfileChoice> profile_choices()
{
    static constexpr std::array<ProfileChoice, 3> choices{{
        {"scope", scope_profile},
        {"crt", crt_profile},
        {"galvo", galvo_profile},
    }};
    return choices;
}

BeamProfile chosen_profile(const std::string& name)
{
    const auto found = std::ranges::find(profile_choices(), name, &ProfileChoice::name);
    if (found != profile_choices().end())
        return found->profile;
    std::vector<std::string_view> known;
    std::ranges::transform(profile_choices(), std::back_inserter(known), &ProfileChoice::name);
    throw Failure("there is no beam " + kfast::quoted(name) + ": " + suggestion(name, known));
}

}
