#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene/reading.hpp"

#include <optional>

namespace kfast::scene {

/// Nothing when the node gives no usable object; what is wrong is reported.
std::optional<Object> read_object(const kdl::Node& node, Reading& reading);

}
