#include "host/scene/input_reader.hpp"

#include "host/kdl/canonical.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace kfast::scene {
namespace {

constexpr NodeForm input_form{input_name, "input NAME min=NUMBER max=NUMBER default=NUMBER", 1, 1};

struct InputProperties {
    std::int32_t least = 0;
    std::int32_t most = 1000;
    std::optional<std::int32_t> usual;
};

template <auto InputProperties::*value>
bool read_value(const kdl::Value& written, InputProperties& input, Reading& reading)
{
    const auto number = read_number(written, input_values, reading);
    if (number)
        input.*value = thousandths(*number);
    return number.has_value();
}

constexpr std::array input_rules{
    PropertyRule<InputProperties>{"min", read_value<&InputProperties::least>},
    PropertyRule<InputProperties>{"max", read_value<&InputProperties::most>},
    PropertyRule<InputProperties>{"default", read_value<&InputProperties::usual>},
};

bool check_range(const kdl::Node& node, const InputProperties& input, Reading& reading)
{
    if (input.most <= input.least)
        return reading.report.error(property_place(node, has_property(node, "max") ? "max" : "min"),
                                    "the range of this input is empty",
                                    "let max= be greater than min= (0 and 1 if they are left out)");
    if (input.usual.value_or(input.least) < input.least || input.usual.value_or(input.most) > input.most)
        return reading.report.error(property_place(node, "default"), "this value is not within min and max",
                                    allowed({input.least / 1000.0, input.most / 1000.0}));
    return true;
}

}

void add_input(const kdl::Node& node, Reading& reading)
{
    if (!fits(node, input_form, reading))
        return;
    InputProperties properties;
    if (read_properties(node, input_rules, properties, reading))
        check_range(node, properties, reading);
    const kdl::Value& value = node.arguments.front();
    const auto name = read_name(value, reading);
    const Place place = span(node.name_place, value.place);
    if (!name)
        return;
    if (const InputEntry* const earlier = reading.inputs.find(*name)) {
        report_double("an input", *name, place, earlier->place, reading.report);
        return;
    }
    if (reading.inputs.entries.size() == most_inputs)
        reading.report.error(place, "a scene has at most " + std::to_string(most_inputs) + " inputs");
    Input input{.name = std::string{*name}, .least = properties.least, .most = properties.most};
    const bool has_range = input.most > input.least;
    input.usual = properties.usual.value_or(has_range ? std::clamp(0, input.least, input.most) : 0);
    // One that is wrong is kept, so that what names it is not wrong as well.
    reading.inputs.entries.push_back({.input = input, .place = place, .is_range_known = has_range});
}

void warn_of_unused_inputs(Reading& reading)
{
    for (const InputEntry& entry : reading.inputs.entries)
        if (!entry.is_used)
            reading.report.warning(entry.place, "the input " + quoted(entry.input.name) + " moves nothing",
                                   "add input=" + kdl::string_form(entry.input.name) +
                                       " to a track, an item or a pose, or remove it");
}

}
