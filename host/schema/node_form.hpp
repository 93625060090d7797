#pragma once

#include "host/kdl/document.hpp"
#include "host/schema/report.hpp"

#include <cstddef>
#include <limits>
#include <string_view>

namespace kfast::schema {

/// What a kind of node looks like, apart from its properties.
struct NodeForm {
    std::string_view name;
    std::string_view usage; ///< shown where a node does not fit
    std::size_t min_values = 0;
    std::size_t max_values = 0;
    bool takes_nodes = false;

    static constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();
};

/// Whether `node` fits its form; reports what does not.
bool fits(const kdl::Node& node, const NodeForm& form, Report& report);

}
