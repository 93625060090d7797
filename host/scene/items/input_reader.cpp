#include "host/scene/items/input_reader.hpp"

#include "host/kdl/canonical.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/shapes/shape_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace kfast::scene {

InputType input_type(const kdl::Node& node)
{
    const auto property = std::ranges::find(node.properties, "kind", &kdl::Property::name);
    if (property == node.properties.end())
        return InputType::number;
    const auto* const name = property->value.string();
    const auto type =
        name != nullptr ? std::ranges::find(input_types, *name, &Word<InputType>::name) : input_types.end();
    return type != input_types.end() ? type->meaning : InputType::number;
}

bool check_input_type(const kdl::Value& value, SceneContext& context)
{
    return read_word(value, input_types, context.report).has_value();
}

namespace {

constexpr NodeForm number_form{input_name, "input NAME min=NUMBER max=NUMBER default=NUMBER", 1, 1};
constexpr NodeForm drawing_form{input_name, "input NAME kind=drawing points=NUMBER { shapes }", 1, 1, true};

constexpr NodeForm text_form{input_name, "input NAME kind=text glyphs=\"0-9\" max=NUMBER", 1, 1};

const NodeForm& form_of(InputType type)
{
    switch (type) {
    case InputType::number:
        break;
    case InputType::text:
        return text_form;
    case InputType::drawing:
        return drawing_form;
    }
    return number_form;
}

struct NumberProperties {
    std::int32_t min = 0;
    std::int32_t max = 1000;
    std::optional<std::int32_t> default_value;
};

template <auto NumberProperties::*value>
bool read_value(const kdl::Value& written, NumberProperties& input, SceneContext& context)
{
    const auto number = read_number(written, input_values, context.report);
    if (number)
        input.*value = thousandths(*number);
    return number.has_value();
}

constexpr std::array number_rules{
    PropertyRule<NumberProperties>{"kind", check_own_type<NumberProperties>,
                                   ValueKind::one_of<input_types>()},
    PropertyRule<NumberProperties>{"min", read_value<&NumberProperties::min>,
                                   ValueKind::number(input_values)},
    PropertyRule<NumberProperties>{"max", read_value<&NumberProperties::max>,
                                   ValueKind::number(input_values)},
    PropertyRule<NumberProperties>{"default", read_value<&NumberProperties::default_value>,
                                   ValueKind::number(input_values)},
};

bool check_range(const kdl::Node& node, const NumberProperties& input, SceneContext& context)
{
    if (input.max <= input.min)
        return context.report.error(property_span(node, has_property(node, "max") ? "max" : "min"),
                                    "the range of this input is empty",
                                    "let max= be greater than min= (0 and 1 if they are left out)");
    if (input.default_value.value_or(input.min) < input.min ||
        input.default_value.value_or(input.max) > input.max)
        return context.report.error(property_span(node, "default"), "this value is not within min and max",
                                    schema::allowed({input.min / 1000.0, input.max / 1000.0}));
    return true;
}

InputEntry read_number_input(const kdl::Node& node, SceneContext& context)
{
    NumberProperties properties;
    if (read_properties(node, number_rules, properties, context))
        check_range(node, properties, context);
    const bool has_range = properties.max > properties.min;
    InputEntry entry{.input = {.name = {}, .min = properties.min, .max = properties.max},
                     .place = {},
                     .is_range_known = has_range};
    entry.input.default_value =
        properties.default_value.value_or(has_range ? std::clamp(0, properties.min, properties.max) : 0);
    return entry;
}

InputEntry read_entry(const kdl::Node& node, SceneContext& context)
{
    InputEntry entry{.input = {.name = {}, .type = input_type(node)}, .place = {}};
    switch (entry.input.type) {
    case InputType::number:
        return read_number_input(node, context);
    case InputType::text:
        entry.input.text = read_text_input(node, context);
        break;
    case InputType::drawing:
        entry.input.drawing = read_drawing_input(node, context);
        break;
    }
    return entry;
}

/// What makes use of such an input.
std::string hint_of_unused(const Input& input)
{
    const std::string name = kdl::string_form(input.name);
    switch (input.type) {
    case InputType::number:
        break;
    case InputType::text:
        return "add 'text input=" + name + " at=\"X,Y\" size=PIXELS' to an object, or remove it";
    case InputType::drawing:
        return "add live=" + name + " to an object, or remove it";
    }
    return "add input=" + name + " to a track, an item, a pose or a text, or remove it";
}

}

void add_input(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, form_of(input_type(node)), context.report))
        return;
    InputEntry entry = read_entry(node, context);
    const kdl::Value& value = node.arguments.front();
    const auto name = read_name(value, context.report);
    const SourceSpan place = span(node.name_span, value.place);
    if (!name)
        return;
    if (const InputEntry* const earlier = context.inputs.find(*name)) {
        report_duplicate("an input", *name, place, earlier->place, context.report);
        return;
    }
    if (context.inputs.entries.size() == max_inputs)
        context.report.error(place, "a scene has at most " + std::to_string(max_inputs) + " inputs");
    // An invalid one is kept, so that references to it are not errors as well.
    entry.input.name = *name;
    entry.place = place;
    context.inputs.entries.push_back(std::move(entry));
}

void warn_of_unused_inputs(SceneContext& context)
{
    for (const InputEntry& entry : context.inputs.entries)
        if (!entry.is_used)
            context.report.warning(entry.place,
                                   "the input " + in_quotes(entry.input.name) +
                                       (entry.input.type == InputType::number ? " moves" : " shows") +
                                       " nothing",
                                   hint_of_unused(entry.input));
}

std::vector<NodeSchema> input_schema()
{
    std::vector<NodeSchema> words{{input_name, number_form, {any_name}, schema_of(number_rules)},
                                  {input_name, text_form, {any_name}, text_input_schema()},
                                  {input_name,
                                   drawing_form,
                                   {any_name},
                                   drawing_input_schema(),
                                   {shape_names().begin(), shape_names().end()}}};
    for (std::size_t i = 0; i < words.size(); ++i) {
        PropertySchema& kind = words[i].properties.front();
        kind.kind.words = kind.kind.words.subspan(i, 1);
        kind.required = input_types[i].meaning != InputType::number;
    }
    return words;
}

}
