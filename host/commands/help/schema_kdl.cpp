#include "host/commands/help/schema_lists.hpp"

#include "host/kdl/canonical.hpp"
#include "host/scene/values/value_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace kfast {
namespace {

using schema::NodeForm;
using schema::NodeSchema;
using schema::PropertySchema;
using schema::ValueKind;
using schema::ValueType;

std::string string_of(std::string_view text) { return '"' + std::string{text} + '"'; }

std::string id_query(std::string_view id) { return "#\"[id=" + string_of(id) + "]\"#"; }

/// Writes lines, each as deep as the braces around it.
class Lines {
public:
    void add(const std::string& line) { text_ += std::string(4 * depth_, ' ') + line + '\n'; }
    void open(const std::string& line)
    {
        add(line + " {");
        ++depth_;
    }
    void close()
    {
        --depth_;
        add("}");
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::size_t depth_ = 0;
};

std::string_view kdl_type(ValueType type)
{
    switch (type) {
    case ValueType::number:
    case ValueType::whole_number:
    case ValueType::time:
    case ValueType::moment:
        return "number";
    case ValueType::truth:
        return "boolean";
    default:
        return "string";
    }
}

void add_kind(const ValueKind& kind, Lines& lines)
{
    lines.add("type " + string_of(kdl_type(kind.type)));
    if (!kind.words.empty()) {
        std::string words = "enum";
        for (const std::string_view word : kind.words)
            words += ' ' + string_of(word);
        lines.add(words);
    }
    if (std::isfinite(kind.range.low))
        lines.add("\">=\" " + scene::text_of(kind.range.low));
    if (std::isfinite(kind.range.high))
        lines.add("\"<=\" " + scene::text_of(kind.range.high));
    if (kind.type == ValueType::whole_number)
        lines.add("% 1");
    if (kind.type == ValueType::time || kind.type == ValueType::moment) {
        lines.open("tag");
        lines.add("enum \"s\" \"ms\"");
        lines.close();
    }
}

std::string description(const ValueKind& kind)
{
    switch (kind.type) {
    case ValueType::time:
        return "a time: frames, (s)seconds or (ms)milliseconds";
    case ValueType::moment:
        return "a time, or a value of the input that its node goes by";
    case ValueType::colour:
        return "a colour: #rgb, #rrggbb, either with opacity, or a name";
    case ValueType::name:
        return "a name";
    case ValueType::law:
        return "a velocity law: a word, or one with numbers such as steps(n) or bezier(x1,y1,x2,y2)";
    case ValueType::spot:
        return "a place: X,Y";
    case ValueType::path:
        return "path data of SVG";
    case ValueType::font:
        return "a bundled font, or a file beside the scene";
    default:
        return std::string{kind.unit};
    }
}

std::string with_description(std::string head, const std::string& description)
{
    return description.empty() ? head : head + " description=" + string_of(description);
}

bool is_same_kind(const ValueKind& one, const ValueKind& other)
{
    return one.type == other.type && one.unit == other.unit && one.range.low == other.range.low &&
           one.range.high == other.range.high && std::ranges::equal(one.words, other.words);
}

void merge(std::vector<PropertySchema>& all, const std::vector<PropertySchema>& more)
{
    for (PropertySchema& property : all)
        if (std::ranges::find(more, property.name, &PropertySchema::name) == more.end())
            property.required = false;
    for (const PropertySchema& property : more) {
        const auto known = std::ranges::find(all, property.name, &PropertySchema::name);
        if (known == all.end()) {
            all.push_back(property);
            all.back().required = false;
            continue;
        }
        known->required = known->required && property.required;
        if (!is_same_kind(known->kind, property.kind))
            known->kind = ValueKind::plain(ValueType::none);
    }
}

/// All ways to write a node in one.
void merge(NodeSchema& all, const NodeSchema& more)
{
    merge(all.properties, more.properties);
    all.form.min_values = std::min(all.form.min_values, more.form.min_values);
    all.form.max_values = std::max(all.form.max_values, more.form.max_values);
    for (std::size_t i = 0; i < std::min(all.values.size(), more.values.size()); ++i)
        if (!is_same_kind(all.values[i], more.values[i]))
            all.values[i] = ValueKind::plain(ValueType::none);
    if (more.values.size() > all.values.size())
        all.values = more.values;
    for (const std::string_view id : more.inside)
        if (std::ranges::find(all.inside, id) == all.inside.end())
            all.inside.push_back(id);
}

std::vector<NodeSchema> merged(const scene::LanguageSchema& words)
{
    std::vector<NodeSchema> nodes;
    for (const NodeSchema& node : words.nodes) {
        const auto known = std::ranges::find(nodes, node.id, &NodeSchema::id);
        if (known == nodes.end())
            nodes.push_back(node);
        else
            merge(*known, node);
    }
    return nodes;
}

void add_values(const NodeSchema& node, Lines& lines)
{
    for (std::size_t i = 0; i < node.values.size(); ++i) {
        const bool is_last = i + 1 == node.values.size();
        const std::size_t rest = node.form.min_values > i ? node.form.min_values - i : 0;
        lines.open(with_description("value", description(node.values[i])));
        lines.add("min " + std::to_string(is_last ? rest : std::min<std::size_t>(rest, 1)));
        if (!is_last)
            lines.add("max 1");
        else if (node.form.max_values != NodeForm::any_number)
            lines.add("max " + std::to_string(node.form.max_values - i));
        if (node.values[i].type != ValueType::none)
            add_kind(node.values[i], lines);
        lines.close();
    }
}

void add_property(const PropertySchema& property, Lines& lines)
{
    lines.open(with_description("prop " + string_of(property.name), description(property.kind)));
    if (property.required)
        lines.add("required #true");
    if (property.kind.type != ValueType::none)
        add_kind(property.kind, lines);
    lines.close();
}

void add_references(const std::vector<std::string_view>& ids, Lines& lines)
{
    for (const std::string_view id : ids)
        lines.add("node ref=" + id_query(id));
}

void add_node(const NodeSchema& node, Lines& lines)
{
    const std::string name = node.takes_any_name ? "" : ' ' + string_of(node.form.name);
    lines.open("node" + name + " id=" + string_of(node.id) +
               " description=" + kdl::string_form(node.form.usage));
    for (const PropertySchema& property : node.properties)
        add_property(property, lines);
    if (node.any_property)
        lines.add("other-props-allowed #true");
    add_values(node, lines);
    if (!node.inside.empty()) {
        lines.open("children");
        add_references(node.inside, lines);
        lines.close();
    }
    lines.close();
}

}

std::string schema_kdl(const scene::LanguageSchema& words)
{
    Lines lines;
    lines.add("// Made by \"kfast schema\". A text with an expression may stand in the place of a number.");
    lines.open("document");
    lines.open("info");
    lines.add("title \"Scenes of kfast\" lang=\"en\"");
    lines.add("description \"Vector key-frame animation for microcontroller-driven displays\" lang=\"en\"");
    lines.close();
    add_references(words.outermost, lines);
    lines.open("definitions");
    for (const NodeSchema& node : merged(words))
        add_node(node, lines);
    lines.close();
    lines.close();
    return lines.text();
}

}
