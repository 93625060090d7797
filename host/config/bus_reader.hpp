#pragma once

#include "host/config/draft.hpp"
#include "host/schema/report.hpp"

namespace kfast::config {

/// `bus spi clock=(MHz)62.5`, `bus i2c address=0x3D`. Whether it was good; reports what is wrong.
bool read_bus(const kdl::Node& node, Draft& draft, schema::Report& report);

}
