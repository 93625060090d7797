#include "host/commands/help/schema_markdown.hpp"

#include "host/commands/help/schema_json.hpp"
#include "host/scene/values/value_reader.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace kfast {
namespace {

using schema::NodeSchema;
using schema::PropertySchema;
using schema::ValueKind;
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
