#include "host/beam/beam_text.hpp"

#include "host/beam/profile_choice.hpp"
#include "host/kdl/parser.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_reader.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

namespace kfast {

namespace {

using schema::assign, schema::PropertyRule, schema::Range, schema::Report, schema::Word;

constexpr Range rates{1000, 1e6};
constexpr Range steps{0.001, 100};
constexpr Range steps_or_none{0, 100};
constexpr Range waits{0, std::numeric_limits<std::uint8_t>::max()};
constexpr Range refreshes{1, std::numeric_limits<std::uint8_t>::max()};
constexpr Range resolutions{64, 4096};
constexpr Range places{-50, 50};
constexpr std::uint32_t fewest_points = 16;

constexpr std::array brightness_words{
    Word<BeamBrightness>{"none", BeamBrightness::none},
    Word<BeamBrightness>{"level", BeamBrightness::by_level},
    Word<BeamBrightness>{"speed", BeamBrightness::by_speed},
};

bool read_rate(const kdl::Value& value, BeamProfile& beam, Report& report)
{
    const auto rate = read_quantity(value, schema::frequency, rates, report);
    if (rate)
        beam.rate = static_cast<std::uint32_t>(std::lround(*rate));
    return rate.has_value();
}

template <std::uint16_t BeamProfile::*step>
bool read_step(const kdl::Value& value, Range range, BeamProfile& beam, Report& report)
{
    const auto percent = read_number(value, range, report);
    if (percent)
        beam.*step = field_step(*percent);
    return percent.has_value();
}

bool read_lit_step(const kdl::Value& value, BeamProfile& beam, Report& report)
{
    return read_step<&BeamProfile::lit_step>(value, steps, beam, report);
}

bool read_travel_step(const kdl::Value& value, BeamProfile& beam, Report& report)
{
    return read_step<&BeamProfile::travel_step>(value, steps_or_none, beam, report);
}

template <std::uint8_t BeamProfile::*wait>
bool read_wait(const kdl::Value& value, BeamProfile& beam, Report& report)
{
    return assign(read_whole_number(value, waits, report), beam.*wait);
}

bool read_min_refresh(const kdl::Value& value, BeamProfile& beam, Report& report)
{
    return assign(read_whole_number(value, refreshes, report), beam.min_refresh);
}

bool read_resolution(const kdl::Value& value, BeamProfile& beam, Report& report)
{
    const auto resolution = read_whole_number(value, resolutions, report);
    if (!resolution)
        return false;
    beam.resolution = static_cast<std::uint16_t>(*resolution);
    return std::has_single_bit(beam.resolution) ||
           report.error(value.place, "a resolution is a power of two",
                        "write 64, 128, 256, 512, 1024, 2048 or 4096");
}

bool read_brightness(const kdl::Value& value, BeamProfile& beam, Report& report)
{
    return assign(read_word(value, brightness_words, report), beam.brightness);
}

template <std::int16_t FieldPoint::*axis>
bool read_park(const kdl::Value& value, BeamProfile& beam, Report& report)
{
    const auto percent = read_number(value, places, report);
    if (percent)
        beam.park.*axis = field_place(*percent);
    return percent.has_value();
}

bool read_laser(const kdl::Value& value, BeamProfile& beam, Report& report)
{
    return assign(read_flag(value, report), beam.is_laser);
}

constexpr std::array rules{
    PropertyRule<BeamProfile>{"rate", read_rate},
    PropertyRule<BeamProfile>{"lit-step", read_lit_step},
    PropertyRule<BeamProfile>{"travel-step", read_travel_step},
    PropertyRule<BeamProfile>{"corner-dwell", read_wait<&BeamProfile::corner_dwell>},
    PropertyRule<BeamProfile>{"lit-dwell", read_wait<&BeamProfile::lit_dwell>},
    PropertyRule<BeamProfile>{"arrival-dwell", read_wait<&BeamProfile::arrival_dwell>},
    PropertyRule<BeamProfile>{"leave-dwell", read_wait<&BeamProfile::leave_dwell>},
    PropertyRule<BeamProfile>{"light-delay", read_wait<&BeamProfile::light_delay>},
    PropertyRule<BeamProfile>{"least-refresh", read_min_refresh},
    PropertyRule<BeamProfile>{"resolution", read_resolution},
    PropertyRule<BeamProfile>{"brightness", read_brightness},
    PropertyRule<BeamProfile>{"park-x", read_park<&FieldPoint::x>},
    PropertyRule<BeamProfile>{"park-y", read_park<&FieldPoint::y>},
    PropertyRule<BeamProfile>{"laser", read_laser},
};

const ProfileChoice* named_profile(const kdl::Value& value, Report& report)
{
    const auto name = read_text(value, report);
    if (!name)
        return nullptr;
    const ProfileChoice* const choice = profile_named(*name);
    if (choice == nullptr)
        report_unknown_word(value, *name, profile_names(), report);
    return choice;
}

bool has_time_to_draw(const kdl::Node& node, const BeamProfile& beam, Report& report)
{
    if (beam.rate / beam.min_refresh >= fewest_points)
        return true;
    return report.error(schema::property_span(node, "least-refresh"),
                        "at this rate a picture would have fewer than " + std::to_string(fewest_points) +
                            " points",
                        "let least-refresh be at most " + std::to_string(beam.rate / fewest_points));
}

}

std::optional<BeamProfile> read_beam(const kdl::Node& node, Report& report)
{
    const ProfileChoice* const base = named_profile(node.arguments.front(), report);
    BeamProfile beam = base != nullptr ? base->profile : BeamProfile{};
    if (!read_properties(node, rules, beam, report) || base == nullptr ||
        !has_time_to_draw(node, beam, report))
        return std::nullopt;
    return beam;
}

std::optional<ChosenBeam> read_beam_text(const SourceText& source, Diagnostics& diagnostics)
{
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    if (diagnostics.has_errors())
        return std::nullopt;
    Report report{source, diagnostics};
    const kdl::Node* const node = only_node(document, beam_form, "a description of a beam", report);
    if (node == nullptr || !fits(*node, beam_form, report))
        return std::nullopt;
    const auto profile = read_beam(*node, report);
    if (!profile)
        return std::nullopt;
    return ChosenBeam{*profile, profile_named(*node->arguments.front().string())->name};
}

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
