#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/reading.hpp"

#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view bones_name = "bones";

/// Adds the skeleton that `node` describes to those of `reading`; reports what is wrong.
void add_skeleton(const kdl::Node& node, Reading& reading);

/// After all objects have been read.
void warn_of_unused_skeletons(Reading& reading);

NodeWords bones_words();

}
