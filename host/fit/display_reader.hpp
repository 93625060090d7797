#pragma once

#include "host/fit/display.hpp"
#include "host/kdl/document.hpp"
#include "host/schema/report.hpp"

#include <optional>

namespace kfast::fit {

/// `panel st7789`, `panel st7789 240 320` or `panel 240 240 format=rgb565`. Reports mistakes and then
/// returns nothing.
std::optional<Display> read_display(const kdl::Node& node, schema::Report& report);

}
