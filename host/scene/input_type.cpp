#include "host/scene/input_type.hpp"

#include "host/scene/value_reader.hpp"

#include <algorithm>
#include <array>

namespace kfast::scene {
namespace {

constexpr std::array types{
    Word<InputType>{"number", InputType::number},
    Word<InputType>{"text", InputType::text},
    Word<InputType>{"drawing", InputType::drawing},
};

}

InputType input_type(const kdl::Node& node)
{
    const auto property = std::ranges::find(node.properties, "kind", &kdl::Property::name);
    if (property == node.properties.end())
        return InputType::number;
    const auto* const name = property->value.string();
    const auto type = name != nullptr ? std::ranges::find(types, *name, &Word<InputType>::name) : types.end();
    return type != types.end() ? type->meaning : InputType::number;
}

bool check_input_type(const kdl::Value& value, Reading& reading)
{
    return read_word(value, types, reading).has_value();
}

}
