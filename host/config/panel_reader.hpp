#pragma once

#include "host/config/draft.hpp"
#include "host/schema/report.hpp"

namespace kfast::config {

/// `panel st7789`, `panel st7789 135 240 column=52 row=40 …`: what is not given is as in the controller's
/// usual module. Whether it was good; reports what is wrong.
bool read_panel(const kdl::Node& node, Draft& draft, schema::Report& report);

}
