#pragma once

#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_kind.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace kfast::schema {

/// What may be said of a property, as its rule has it.
struct PropertySchema {
    std::string_view name;
    ValueKind kind;
    bool required = false;
    std::string_view needs = {}; ///< another property, without which this one does nothing
};

/// What may be said of a node that stands in a certain place, as its reader has it.
struct NodeSchema {
    /// Its name; where nodes of one name differ by where they stand, "NAME of PARENT". Several entries of one
    /// id are several ways to write such a node.
    std::string_view id;
    NodeForm form;                      ///< its name stands for any name if `takes_any_name`
    std::vector<ValueKind> values = {}; ///< the last holds for all that follow
    std::vector<PropertySchema> properties = {};
    std::vector<std::string_view> inside = {}; ///< ids of the nodes that it may hold
    bool takes_any_name = false;               ///< that of a colour or a bone of the scene
};

template <class Target, class Context, std::size_t count>
std::vector<PropertySchema> words_of(const std::array<PropertyRule<Target, Context>, count>& rules)
{
    std::vector<PropertySchema> words;
    words.reserve(count);
    for (const auto& rule : rules)
        words.push_back({rule.name, rule.kind, rule.required, rule.needs});
    return words;
}

}
