#include "host/beam/beam_text.hpp"

#include "host/beam/field_share.hpp"
#include "host/beam/profile_choice.hpp"
#include "host/schema/quantity_reader.hpp"
#include "host/schema/value_reader.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

std::string step_text(std::uint16_t step)
{
    return schema::shortest_text(step / units_per_percent,
                                 [step](double percent) { return field_step(percent) == step; });
}

std::string place_text(std::int16_t place)
{
    return schema::shortest_text(place / units_per_percent,
                                 [place](double percent) { return field_place(percent) == place; });
}

std::string brightness_text(BeamBrightness brightness)
{
    switch (brightness) {
    case BeamBrightness::none:
        return "none";
    case BeamBrightness::by_level:
        return "level";
    case BeamBrightness::by_speed:
        return "speed";
    }
    return {};
}

constexpr std::size_t property_count = 14;

std::array<std::string, property_count> property_texts(const BeamProfile& beam)
{
    return {
        "rate=" + schema::quantity_text(beam.rate, schema::frequency),
        "lit-step=" + step_text(beam.lit_step),
        "travel-step=" + step_text(beam.travel_step),
        "corner-dwell=" + std::to_string(beam.corner_dwell),
        "lit-dwell=" + std::to_string(beam.lit_dwell),
        "arrival-dwell=" + std::to_string(beam.arrival_dwell),
        "leave-dwell=" + std::to_string(beam.leave_dwell),
        "light-delay=" + std::to_string(beam.light_delay),
        "least-refresh=" + std::to_string(beam.min_refresh),
        "resolution=" + std::to_string(beam.resolution),
        "brightness=" + brightness_text(beam.brightness),
        "park-x=" + place_text(beam.park.x),
        "park-y=" + place_text(beam.park.y),
        std::string{"laser="} + (beam.is_laser ? "#true" : "#false"),
    };
}

/// How many properties two profiles have in common.
std::size_t likeness(const BeamProfile& one, const BeamProfile& other)
{
    const auto ones = property_texts(one);
    const auto others = property_texts(other);
    std::size_t equal = 0;
    for (std::size_t i = 0; i < property_count; ++i)
        equal += ones[i] == others[i] ? 1 : 0;
    return equal;
}

}

std::string beam_text(const BeamProfile& profile, std::string_view indent)
{
    constexpr std::size_t widest = 100;
    const auto base = std::ranges::max_element(profile_choices(), {}, [&](const ProfileChoice& choice) {
        return likeness(profile, choice.profile);
    });
    std::string text = "beam " + std::string{base->name};
    std::size_t line_begin = 0;
    for (const std::string& property : property_texts(profile)) {
        if (text.size() - line_begin + property.size() > widest) {
            text += " \\\n";
            line_begin = text.size();
            text += std::string{indent} + "   ";
        }
        text += ' ' + property;
    }
    return text;
}

}
