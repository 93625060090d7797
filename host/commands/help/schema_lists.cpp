#include "host/commands/help/schema_lists.hpp"

#include "host/commands/text/json_text.hpp"
#include "host/scene/values/value_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

namespace {

using Json = nlohmann::ordered_json;
using schema::NodeForm;
using schema::NodeSchema;
using schema::PropertySchema;
using schema::ValueKind;

/// Whole numbers without a point.
Json number_of(double number)
{
    if (std::trunc(number) == number)
        return static_cast<std::int64_t>(number);
    return number;
}

void add_kind(Json& json, const ValueKind& kind)
{
    json["type"] = type_name(kind.type);
    if (std::isfinite(kind.range.low))
        json["least"] = number_of(kind.range.low);
    if (std::isfinite(kind.range.high))
        json["most"] = number_of(kind.range.high);
    if (!kind.unit.empty())
        json["unit"] = kind.unit;
    if (!kind.words.empty())
        json["words"] = std::vector<std::string_view>(kind.words.begin(), kind.words.end());
}

Json json_of(const PropertySchema& property)
{
    Json json{{"name", property.name}};
    add_kind(json, property.kind);
    if (property.required)
        json["required"] = true;
    if (!property.needs.empty())
        json["needs"] = property.needs;
    return json;
}

Json json_of(std::span<const PropertySchema> properties)
{
    Json list = Json::array();
    for (const PropertySchema& property : properties)
        list.push_back(json_of(property));
    return list;
}

Json values_of(const NodeSchema& node)
{
    Json kinds = Json::array();
    for (const ValueKind& kind : node.values) {
        Json json;
        add_kind(json, kind);
        kinds.push_back(std::move(json));
    }
    const bool is_endless = node.form.max_values == NodeForm::any_number;
    return {{"least", node.form.min_values},
            {"most", is_endless ? Json() : Json(node.form.max_values)},
            {"kinds", std::move(kinds)}};
}

Json json_of(const NodeSchema& node, const scene::LanguageSchema& words)
{
    Json json{{"id", node.id}, {"name", node.form.name}};
    if (node.takes_any_name)
        json["any_name"] = true;
    json["usage"] = node.form.usage;
    json["inside_of"] = holders(words, node.id);
    json["values"] = values_of(node);
    json["properties"] = json_of(node.properties);
    if (node.any_property)
        add_kind(json["any_property"], *node.any_property);
    json["nodes"] = node.inside;
    return json;
}

}

std::string_view type_name(schema::ValueType type)
{
    using schema::ValueType;
    switch (type) {
    case ValueType::none:
        break;
    case ValueType::number:
        return "number";
    case ValueType::whole_number:
        return "whole number";
    case ValueType::time:
        return "time";
    case ValueType::moment:
        return "moment";
    case ValueType::colour:
        return "colour";
    case ValueType::name:
        return "name";
    case ValueType::text:
        return "text";
    case ValueType::word:
        return "word";
    case ValueType::truth:
        return "truth";
    case ValueType::law:
        return "law";
    case ValueType::spot:
        return "place";
    case ValueType::path:
        return "path";
    case ValueType::font:
        return "font";
    }
    return "";
}

std::string schema_json(const scene::LanguageSchema& words)
{
    Json nodes = Json::array();
    for (const NodeSchema& node : words.nodes)
        nodes.push_back(json_of(node, words));
    return json_text({{"outermost", words.outermost},
                      {"nodes", std::move(nodes)},
                      {"quantities", json_of(words.quantities)},
                      {"laws", words.laws},
                      {"colours", words.colours},
                      {"fonts", words.fonts}});
}

namespace {

using schema::ValueType;

std::string code(std::string_view text) { return '`' + std::string{text} + '`'; }

void append(std::string& list, const std::string& entry)
{
    list.append(list.empty() ? "" : ", ").append(entry);
}

/// "-2047", with the sign that the documents write, and commas between thousands.
std::string number_text(double number)
{
    std::string text = scene::text_of(std::abs(number));
    const std::size_t point = std::min(text.find('.'), text.size());
    for (std::size_t at = point; at > 3 && point > 4; at -= 3)
        text.insert(at - 3, ",");
    return (number < 0 ? "−" : "") + text;
}

std::string kind_text(const ValueKind& kind)
{
    if (kind.type == ValueType::word) {
        std::string words;
        for (const std::string_view word : kind.words)
            append(words, code(word));
        return words;
    }
    std::string text{type_name(kind.type)};
    if (std::isfinite(kind.range.high))
        text = (kind.type == ValueType::whole_number ? "whole number, " : "") + number_text(kind.range.low) +
               " to " + number_text(kind.range.high);
    if (!kind.unit.empty())
        text += ' ' + std::string{kind.unit};
    return text;
}

std::string row(const NodeSchema& node, const scene::LanguageSchema& words)
{
    std::string inside_of;
    for (const std::string_view id : holders(words, node.id))
        append(inside_of, id.empty() ? "the outermost level" : code(id));
    std::string properties;
    for (const PropertySchema& property : node.properties)
        append(properties, code(property.name) + (property.required ? "\\*" : ""));
    if (node.any_property)
        append(properties, "any name: " + kind_text(*node.any_property));
    return "| " + code(node.id) + " | " + code(node.form.usage) + " | " + inside_of + " | " + properties +
           " |\n";
}

/// A property of the same values in several nodes.
struct Row {
    std::string_view name;
    std::string kind;
    std::vector<std::string_view> ids;
};

std::vector<Row> rows_of_properties(const scene::LanguageSchema& words)
{
    std::vector<Row> rows;
    for (const NodeSchema& node : words.nodes)
        for (const PropertySchema& property : node.properties) {
            const std::string kind = kind_text(property.kind);
            const auto same = [&](const Row& row) { return row.name == property.name && row.kind == kind; };
            auto known = std::ranges::find_if(rows, same);
            if (known == rows.end())
                known = rows.insert(known, {property.name, kind, {}});
            if (std::ranges::find(known->ids, node.id) == known->ids.end())
                known->ids.push_back(node.id);
        }
    std::ranges::stable_sort(rows, {}, &Row::name);
    return rows;
}

}

std::string schema_markdown(const scene::LanguageSchema& words)
{
    std::string text =
        "| node | written | inside of | properties, those with \\* needed |\n|---|---|---|---|\n";
    for (const NodeSchema& node : words.nodes) {
        const std::string line = row(node, words);
        text += text.ends_with(line) ? "" : line; // symbols are written alike, whatever they hold
    }
    text += "\n| property | values | of |\n|---|---|---|\n";
    for (const Row& row : rows_of_properties(words)) {
        std::string ids;
        for (const std::string_view id : row.ids)
            append(ids, code(id));
        text += "| " + code(row.name) + " | " + row.kind + " | " + ids + " |\n";
    }
    return text;
}

}
