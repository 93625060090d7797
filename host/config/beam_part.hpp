#pragma once

#include "host/config/draft.hpp"
#include "host/schema/report.hpp"

namespace kfast::config {

/// `beam galvo rate=(kHz)30 …` in place of a panel. Whether it was good; reports what is wrong.
bool read_beam_part(const kdl::Node& node, Draft& draft, schema::Report& report);

/// Whether `board` has either a panel or a beam, and the bus for it; reports it if not.
bool check_display(const kdl::Node& board, const Draft& draft, schema::Report& report);

}
