#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene/reading.hpp"

namespace kfast::scene {

/// The properties of an object's node: gives `object` its fill and stroke.
void read_style(const kdl::Node& node, Object& object, Reading& reading);

}
