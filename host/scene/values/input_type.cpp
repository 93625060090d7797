#include "host/scene/values/input_type.hpp"

#include "host/scene/values/value_reader.hpp"

#include <algorithm>
#include <array>

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

}
