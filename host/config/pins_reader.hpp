#pragma once

#include "host/config/draft.hpp"
#include "host/schema/report.hpp"

#include <optional>

namespace kfast::config {

/// The number of a GPIO. Reports what is wrong and then returns nothing.
std::optional<Pin> read_pin(const kdl::Value& value, schema::Report& report);

/// `pins clock=18 data=19 …`. Whether it was good; reports what is wrong.
bool read_pins(const kdl::Node& node, Draft& draft, schema::Report& report);

}
