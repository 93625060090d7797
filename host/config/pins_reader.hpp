#pragma once

#include "host/config/draft.hpp"
#include "host/schema/report.hpp"

#include <optional>

namespace kfast::config {

/// The number of a GPIO. Reports what is wrong and then returns nothing.
std::optional<Pin> read_pin(const kdl::Value& value, schema::Report& report);

/// `pins clock=18 data=19 …`. Whether it was valid; reports what is wrong.
bool read_pins(const kdl::Node& node, Draft& draft, schema::Report& report);

/// `clip idle`. Whether it was valid; reports what is wrong.
bool read_clip(const kdl::Node& node, Draft& draft, schema::Report& report);

/// `button 12 play blink`, `button 13 input open`. Whether it was valid; reports what is wrong.
bool read_button(const kdl::Node& node, Draft& draft, schema::Report& report);

/// `knob 26 place`, `knob 27 brightness`, `knob 28 input gaze`. Whether it was valid; reports what is wrong.
bool read_knob(const kdl::Node& node, Draft& draft, schema::Report& report);

}
