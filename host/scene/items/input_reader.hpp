#pragma once

#include "core/scene/input_view.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/value_kind.hpp"

#include <array>
#include <string_view>

namespace kfast::scene {

inline constexpr std::array input_types{
    Word<InputType>{"number", InputType::number},
    Word<InputType>{"text", InputType::text},
    Word<InputType>{"drawing", InputType::drawing},
};

/// What the property `kind` of an input says; a number if there is none, or if it is invalid.
InputType input_type(const kdl::Node& node);

/// Whether the value of such a property is valid; reports it if not.
bool check_input_type(const kdl::Value& value, SceneContext& context);

/// For the table of properties of an input.
template <class Target>
bool check_own_type(const kdl::Value& value, Target&, SceneContext& context)
{
    return check_input_type(value, context);
}

inline constexpr std::string_view input_name = "input";

/// Adds the input that `node` describes; what is wrong is reported.
void add_input(const kdl::Node& node, SceneContext& context);

/// Called after everything that may use them.
void warn_of_unused_inputs(SceneContext& context);

/// The schema of number, text and drawing inputs.
std::vector<NodeSchema> input_schema();

/// Reads what `node`, an input, says about a drawing; what is wrong is reported.
DrawingInput read_drawing_input(const kdl::Node& node, SceneContext& context);

std::vector<PropertySchema> drawing_input_schema();

/// Reads what an input node of kind=text says. What is wrong is reported, and then a placeholder is returned.
TextInput read_text_input(const kdl::Node& node, SceneContext& context);

std::vector<PropertySchema> text_input_schema();

}
