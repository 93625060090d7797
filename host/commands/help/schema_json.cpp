#include "host/commands/help/schema_json.hpp"

#include "host/commands/text/json_text.hpp"

#include <cmath>
#include <cstdint>
#include <span>

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

}
