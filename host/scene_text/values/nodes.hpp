#pragma once

#include "host/kdl/document.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace kfast::scene_text {

inline kdl::Value text(std::string words)
{
    kdl::Value value;
    value.data = std::move(words);
    return value;
}

inline kdl::Value truth(bool is_true)
{
    kdl::Value value;
    value.data = is_true;
    return value;
}

template <typename... Values>
kdl::Node named_node(std::string_view name, Values... arguments)
{
    kdl::Node node;
    node.name = name;
    (node.arguments.push_back(std::move(arguments)), ...);
    return node;
}

inline void set(kdl::Node& node, std::string_view property, kdl::Value value)
{
    node.properties.push_back({std::string{property}, {}, std::move(value)});
}

}
