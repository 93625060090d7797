#include "host/scene/values/let_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/expression.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/variable_names.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace kfast::scene {

namespace {

using schema::Variable;

constexpr NodeForm let_form{let_name, "let NAME=NUMBER"};
constexpr Range numbers{-schema::largest_number, schema::largest_number};

bool check_name(const kdl::Property& property, SceneContext& context)
{
    const std::string& name = property.name;
    if (name.size() > max_variable_name)
        return context.report.error(property.name_span, "this name is too long",
                                    "that of a variable has at most " + std::to_string(max_variable_name) +
                                        " letters");
    if (schema::is_variable_name(name))
        return true;
    std::string other = name;
    std::ranges::replace(other, '-', '_');
    return context.report.error(property.name_span, in_quotes(name) + " cannot be the name of a variable",
                                other != name && schema::is_variable_name(other)
                                    ? "write " + other + ", for - is minus"
                                    : "it has letters, digits and _, and is no function");
}

void declare(const kdl::Property& property, SceneContext& context)
{
    if (!check_name(property, context))
        return;
    if (context.variables.all().size() == max_variables) {
        context.report.error(property.name_span,
                             "a scene has at most " + std::to_string(max_variables) + " variables");
        return;
    }
    const Variable* const earlier = context.variables.add(
        {.name = property.name, .place = property.name_span, .definition = &property.value});
    const auto first = earlier != nullptr ? std::optional{earlier->place} : property.replaces;
    if (first)
        report_duplicate("a variable", property.name, property.name_span, *first, context.report);
}

void declare_all(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, let_form, context.report))
        return;
    if (node.properties.empty())
        context.report.error(node.name_span, "this let defines nothing",
                             "write " + std::string{let_form.usage});
    for (const kdl::Property& property : node.properties)
        if (!context.report.full())
            declare(property, context);
}

/// Whether the value is a colour or has a unit, as no variable; reports it.
bool is_no_number(const Variable& variable, SceneContext& context)
{
    const kdl::Value& value = *variable.definition;
    if (value.type)
        return !context.report.error(value.place, "a variable has no unit",
                                     "write the unit where it is used: (" + visible(*value.type) + ')' +
                                         variable.name);
    const std::string* const text = value.string();
    if (text == nullptr || context.variables.find(*text) != nullptr || !context.palette.find(*text))
        return false;
    return !context.report.error(value.place, "a variable is a number, and this is a colour",
                                 "give it a name in the palette: palette { " + variable.name + " " +
                                     in_quotes(*text) + " }");
}

std::optional<double> value_of(const Variable& variable, SceneContext& context)
{
    const kdl::Value& value = *variable.definition;
    if (is_no_number(variable, context))
        return std::nullopt;
    if (!is_expression(value, context.report))
        return read_number(value, numbers, context.report);
    schema::Evaluation found = schema::evaluate(*value.string(), context.variables);
    if (found.too_early != nullptr && context.variables.is_circular(variable)) {
        found.finding->message =
            in_quotes(variable.name) + " is defined by itself" +
            (found.too_early == &variable ? "" : ", by way of " + in_quotes(found.too_early->name));
        found.finding->hint = "define one of them by numbers alone";
    }
    return schema::result_of(found, value, context.report);
}

}

void read_variables(const std::vector<const kdl::Node*>& nodes, SceneContext& context)
{
    for (const kdl::Node* node : nodes)
        if (!context.report.full())
            declare_all(*node, context);
    context.report.allow_expressions(context.variables);
    for (Variable& variable : context.variables.all()) {
        if (!context.report.full())
            variable.value = value_of(variable, context);
        variable.is_defined = true;
    }
}

void warn_of_unused_variables(SceneContext& context)
{
    for (const Variable& variable : context.variables.all())
        if (!variable.is_used)
            context.report.warning(variable.place,
                                   "the variable " + in_quotes(variable.name) + " is not used",
                                   "use it in the place of a number, or remove it");
}

NodeSchema let_schema()
{
    NodeSchema schema{let_form.name, let_form};
    schema.any_property = ValueKind::number(numbers);
    return schema;
}

}
