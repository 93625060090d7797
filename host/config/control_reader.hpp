#pragma once

#include "host/config/draft.hpp"
#include "host/schema/report.hpp"

namespace kfast::config {

/// `clip idle`. Whether it was good; reports what is wrong.
bool read_clip(const kdl::Node& node, Draft& draft, schema::Report& report);

/// `button 12 play blink`, `button 13 input open`. Whether it was good; reports what is wrong.
bool read_button(const kdl::Node& node, Draft& draft, schema::Report& report);

/// `knob 26 place`, `knob 27 brightness`, `knob 28 input gaze`. Whether it was good; reports what is wrong.
bool read_knob(const kdl::Node& node, Draft& draft, schema::Report& report);

}
