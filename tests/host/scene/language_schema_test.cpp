#include "host/scene/language_schema.hpp"
#include "host/scene/values/value_reader.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

using schema::NodeSchema;
using schema::PropertySchema;
using schema::ValueKind;
using schema::ValueType;

const scene::LanguageSchema& words()
{
    static const scene::LanguageSchema all = scene::language_schema();
    return all;
}

std::string number_text(double number)
{
    const std::string text = scene::text_of(number);
    return text.find('.') == std::string::npos ? text : text.substr(0, text.find('.') + 7);
}

std::string quoted_text(std::string_view text) { return '"' + std::string{text} + '"'; }

/// Some value of the kind.
std::string value_of(const ValueKind& kind)
{
    switch (kind.type) {
    case ValueType::number:
    case ValueType::whole_number:
        return number_text(std::clamp(1.0, kind.range.low, kind.range.high));
    case ValueType::time:
    case ValueType::moment:
        return "0";
    case ValueType::colour:
        return "red";
    case ValueType::word:
        return quoted_text(kind.words.front());
    case ValueType::truth:
        return "#true";
    case ValueType::law:
        return "hold";
    case ValueType::spot:
        return "\"1,1\"";
    case ValueType::path:
        return "\"M 0 0 L 9 9\"";
    case ValueType::font:
        return "hershey-sans";
    case ValueType::name:
    case ValueType::text:
    case ValueType::none:
        break;
    }
    return "n";
}

/// The node with as little as it needs, but for the property `without`.
std::string node_text(const NodeSchema& node, std::string_view without = "")
{
    std::string text{node.takes_any_name ? "n" : node.form.name};
    for (std::size_t i = 0; i < node.form.min_values; ++i)
        text += ' ' + value_of(node.values[std::min(i, node.values.size() - 1)]);
    for (const PropertySchema& property : node.properties)
        if (property.required && property.name != without)
            text += ' ' + std::string{property.name} + '=' + value_of(property.kind);
    return text;
}

/// What makes readers look at the rest, each in front of what stands inside of such a node.
const std::map<std::string_view, std::string> first_inside{
    {"bones", "bone n 1 1 9 9; bone m 9 9 20 9 parent=n; "},
    {"mesh", "vertices 0 0 0 1 1 1; "},
    {"skeleton", "backbone 1 1 9 9; "},
};

/// Where `id` is looked at best.
std::string_view holder_of(std::string_view id)
{
    const auto holders = scene::holders(words(), id);
    REQUIRE(!holders.empty());
    // Only there a text may be a label.
    const auto best = std::ranges::find(holders, id == "text" ? "object" : "key");
    return best != holders.end() ? *best : holders.front();
}

/// `text`, which stands in a node `id`, in a whole scene.
std::string scene_around(std::string_view id, const std::string& text)
{
    if (id.empty())
        return "kfast 1\ncanvas 100 100\nbones n { bone n 1 1 9 9 }\ninput n\n" + text;
    const auto node = std::ranges::find(words().nodes, id, &NodeSchema::id);
    REQUIRE(node != words().nodes.end());
    const auto first = first_inside.find(id);
    std::string own = node_text(*node);
    if (id == "object")
        own += " fill=red" + std::string{text.starts_with("weights") ? " skin=n { circle 9 9 r=1; " : " { "};
    else if (id == "input")
        own = "input n kind=drawing points=9 { ";
    else
        own += " { ";
    if (first != first_inside.end())
        own += first->second;
    if (id == "skeleton") // where the sides are read together
        own += text.starts_with("left")    ? "right 1 1 9 9; "
               : text.starts_with("right") ? "left 1 1 9 9; "
                                           : "";
    return scene_around(holder_of(id), own + text + " }");
}

std::string findings(std::string_view holder, const std::string& text)
{
    return read(scene_around(holder, text)).findings;
}

bool says(const std::string& findings, const std::string& what)
{
    return findings.find(what) != std::string::npos;
}

/// A skeleton is known everywhere, and refused in words of its own.
bool refuses_node(const std::string& findings, std::string_view name)
{
    return says(findings, "has no node " + quoted_text(name)) ||
           says(findings, "a skeleton stands in a key of an object") ||
           says(findings, "the key of a symbol has no skeleton");
}

std::set<std::string_view> all_property_names()
{
    std::set<std::string_view> names;
    for (const NodeSchema& node : words().nodes)
        for (const PropertySchema& property : node.properties)
            names.insert(property.name);
    return names;
}

std::set<std::string_view> all_node_names()
{
    std::set<std::string_view> names;
    for (const NodeSchema& node : words().nodes)
        if (!node.takes_any_name)
            names.insert(node.form.name);
    return names;
}

bool has(const NodeSchema& node, std::string_view property)
{
    return node.any_property ||
           std::ranges::find(node.properties, property, &PropertySchema::name) != node.properties.end();
}

std::string found_with(const NodeSchema& node, std::string_view property, const std::string& value)
{
    const std::string text =
        node_text(node, property) + (property.empty() ? "" : ' ' + std::string{property} + '=' + value);
    if (node.form.name == "kfast") // the only node that has a fixed place
        return read(text + "\ncanvas 9 9").findings;
    if (node.form.name == "canvas")
        return read("kfast 1\n" + text).findings;
    return findings(holder_of(node.id), text);
}

/// A value that is of no such kind, and what is said of it.
struct Mistake {
    std::string value;
    std::string message;
};

std::vector<Mistake> mistakes(const ValueKind& kind)
{
    switch (kind.type) {
    case ValueType::number:
    case ValueType::whole_number: {
        std::vector<Mistake> wrong{{"n", "a number is expected here"}};
        if (std::isfinite(kind.range.high)) {
            wrong.push_back({number_text(kind.range.low - 1), "this number is out of range"});
            wrong.push_back({number_text(kind.range.high + 1), "this number is out of range"});
        }
        if (kind.type == ValueType::whole_number)
            wrong.push_back({number_text(kind.range.low + 0.5), "a whole number is expected here"});
        return wrong;
    }
    case ValueType::time:
    case ValueType::moment:
        return {{"n", "a number is expected here"}};
    case ValueType::colour:
        return {{"\"#zz\"", "is no colour"}};
    case ValueType::word:
        return {{"xyzzy", "unknown value \"xyzzy\""}};
    case ValueType::truth:
        return {{"7", "#true or #false is expected here"}};
    case ValueType::law:
        return {{"xyzzy", "unknown law \"xyzzy\""}};
    case ValueType::spot:
        return {{"xyzzy", "a place \"X,Y\" is expected here"}};
    case ValueType::font:
        return {{"xyzzy", "unknown font \"xyzzy\""}};
    case ValueType::name:
    case ValueType::text:
    case ValueType::path:
    case ValueType::none:
        break;
    }
    return {};
}

std::vector<std::string> good_values(const ValueKind& kind)
{
    std::vector<std::string> values{value_of(kind)};
    if (std::isfinite(kind.range.high))
        for (const double end : {kind.range.low, kind.range.high})
            values.push_back(number_text(end));
    for (const std::string_view word : kind.words)
        values.push_back(quoted_text(word));
    return values;
}

}

TEST_CASE("the vocabulary is whole: all that it refers to is there, and every node stands somewhere")
{
    for (const NodeSchema& node : words().nodes) {
        CAPTURE(node.id);
        CHECK(!holders(words(), node.id).empty());
        CHECK((node.values.empty() ? node.form.max_values == 0 : node.form.max_values > 0));
        CHECK(node.form.takes_nodes == !node.inside.empty());
        for (const PropertySchema& property : node.properties) {
            CAPTURE(property.name);
            CHECK(property.kind.type != ValueType::none);
            CHECK((property.needs.empty() || has(node, property.needs)));
        }
        for (const std::string_view id : node.inside)
            CHECK(std::ranges::find(words().nodes, id, &NodeSchema::id) != words().nodes.end());
    }
    for (const std::string_view id : words().outermost)
        CHECK(std::ranges::find(words().nodes, id, &NodeSchema::id) != words().nodes.end());
}

TEST_CASE("each node knows the properties that the vocabulary gives it, and no others")
{
    const auto names = all_property_names();
    for (const NodeSchema& node : words().nodes)
        for (const std::string_view name : names) {
            CAPTURE(node.id);
            CAPTURE(name);
            const std::string unknown = "has no property " + quoted_text(name);
            bool in_language = false;
            bool in_compiler = false;
            for (const NodeSchema& way : words().nodes)
                if (way.id == node.id) {
                    in_language = in_language || has(way, name);
                    in_compiler = in_compiler || !says(found_with(way, name, "1"), unknown);
                }
            CHECK(in_compiler == in_language);
        }
}

TEST_CASE("each node holds the nodes that the vocabulary puts into it, and no others")
{
    const auto names = all_node_names();
    std::map<std::string_view, std::set<std::string_view>> inside;
    for (const std::string_view id : words().outermost)
        inside[""].insert(id);
    for (const NodeSchema& node : words().nodes) {
        for (const std::string_view id : node.inside)
            for (const NodeSchema& held : words().nodes)
                if (held.id == id)
                    inside[node.id].insert(held.takes_any_name ? "any" : held.form.name);
    }
    for (const auto& entry : inside)
        for (const std::string_view name : names) {
            const std::string_view holder = entry.first;
            const auto& held = entry.second;
            CAPTURE(holder);
            CAPTURE(name);
            const std::string found = findings(holder, std::string{name});
            if (!held.contains("any"))
                CHECK(refuses_node(found, name) == !held.contains(name));
        }
}

TEST_CASE("nodes that hold none in the vocabulary take none")
{
    for (const NodeSchema& node : words().nodes)
        if (node.inside.empty() && node.form.name != "kfast" && node.form.name != "canvas") {
            CAPTURE(node.id);
            CHECK(says(findings(holder_of(node.id), node_text(node) + " { n }"), "takes no nodes inside"));
        }
}

TEST_CASE("properties take what the vocabulary says, and nothing else")
{
    for (const NodeSchema& node : words().nodes)
        for (const PropertySchema& property : node.properties) {
            CAPTURE(node.id);
            CAPTURE(property.name);
            for (const Mistake& mistake : mistakes(property.kind)) {
                if (node.form.name == "input" && property.name == "kind")
                    continue; // another kind has other properties
                CAPTURE(mistake.value);
                CHECK(says(found_with(node, property.name, mistake.value), mistake.message));
            }
            for (const std::string& value : good_values(property.kind)) {
                CAPTURE(value);
                const std::string found = found_with(node, property.name, value);
                for (const Mistake& mistake : mistakes(property.kind))
                    CHECK(!says(found, mistake.message));
            }
        }
}

TEST_CASE("what the vocabulary calls needed is missed")
{
    for (const NodeSchema& node : words().nodes)
        for (const PropertySchema& property : node.properties) {
            // These tell how the node is written.
            if (property.name == "kind" ||
                (node.form.name == "text" && (property.name == "input" || property.name == "along")))
                continue;
            CAPTURE(node.id);
            CAPTURE(property.name);
            const std::string text = node_text(node, property.name);
            const bool is_elliptical = has(node, "ry") && node.id == "arc";
            const std::string missing = "needs the property " + quoted_text(property.name);
            if (!is_elliptical)
                CHECK(says(findings(holder_of(node.id), text), missing) == property.required);
        }
}

TEST_CASE("values are what the vocabulary says")
{
    for (const NodeSchema& node : words().nodes) {
        if (node.form.name == "kfast" || node.form.name == "canvas" || node.form.min_values == 0)
            continue;
        CAPTURE(node.id);
        const std::string one_less = [&node] {
            NodeSchema less = node;
            --less.form.min_values;
            return node_text(less);
        }();
        CHECK(says(findings(holder_of(node.id), one_less), "needs more values"));
        CHECK(!says(findings(holder_of(node.id), node_text(node)), "needs more values"));
        const ValueKind& last = node.values[std::min(node.form.min_values, node.values.size()) - 1];
        for (const Mistake& mistake : mistakes(last)) {
            // The quantity of a track decides; a face has had a mistake before its third value, for all
            // are 1.
            if (node.id == "track" || node.id == "face" || !std::isfinite(last.range.high))
                continue;
            CAPTURE(mistake.value);
            CHECK(says(findings(holder_of(node.id), one_less + ' ' + mistake.value), mistake.message));
        }
    }
}

TEST_CASE("tracks move the quantities of the vocabulary within their ranges")
{
    for (const PropertySchema& quantity : words().quantities) {
        CAPTURE(quantity.name);
        const auto found = [&](double value) {
            return findings("object",
                            "track " + std::string{quantity.name} + " { at 0 " + number_text(value) + " }");
        };
        CHECK(!says(found(quantity.kind.range.low), "out of range"));
        CHECK(!says(found(quantity.kind.range.high), "out of range"));
        CHECK(says(found(quantity.kind.range.low - 1), "out of range"));
        CHECK(says(found(quantity.kind.range.high + 1), "out of range"));
    }
}

}
