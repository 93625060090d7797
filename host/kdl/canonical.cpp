#include "host/kdl/canonical.hpp"

#include "host/kdl/escape.hpp"
#include "host/kdl/scalar.hpp"

#include <algorithm>

namespace kfast::kdl {

namespace {

constexpr std::size_t indent_width = 4;

std::string canonical_form(std::string_view text)
{
    return is_identifier(text) ? std::string(text) : '"' + escaped(text, Unseen::as_they_are) + '"';
}

struct DataForm {
    std::string operator()(Null) const { return "#null"; }
    std::string operator()(bool value) const { return value ? "#true" : "#false"; }
    std::string operator()(const Number& number) const { return number.canonical; }
    std::string operator()(const std::string& text) const { return canonical_form(text); }
};

std::string type_form(const std::optional<std::string>& type)
{
    return type ? '(' + canonical_form(*type) + ')' : std::string{};
}

std::string value_form(const Value& value)
{
    return type_form(value.type) + std::visit(DataForm{}, value.data);
}

std::vector<const Property*> by_name(const std::vector<Property>& properties)
{
    std::vector<const Property*> sorted(properties.size());
    std::ranges::transform(properties, sorted.begin(), [](const Property& property) { return &property; });
    std::ranges::sort(sorted, {},
                      [](const Property* property) -> const std::string& { return property->name; });
    return sorted;
}

void append_nodes(std::string& text, const std::vector<Node>& nodes, std::size_t indent);

void append_node(std::string& text, const Node& node, std::size_t indent)
{
    text += std::string(indent, ' ') + type_form(node.type) + canonical_form(node.name);
    for (const Value& argument : node.arguments)
        text += ' ' + value_form(argument);
    for (const Property* property : by_name(node.properties))
        text += ' ' + canonical_form(property->name) + '=' + value_form(property->value);
    if (!node.children.empty()) {
        text += " {\n";
        append_nodes(text, node.children, indent + indent_width);
        text += std::string(indent, ' ') + '}';
    }
    text += '\n';
}

void append_nodes(std::string& text, const std::vector<Node>& nodes, std::size_t indent)
{
    for (const Node& node : nodes)
        append_node(text, node, indent);
}

}

std::string string_form(std::string_view text)
{
    const std::string quoted = escaped(text, Unseen::as_codes);
    return is_identifier(text) && quoted == text ? quoted : '"' + quoted + '"';
}

std::string canonical(const Document& document)
{
    if (document.nodes.empty())
        return "\n";
    std::string text;
    append_nodes(text, document.nodes, 0);
    return text;
}

}
