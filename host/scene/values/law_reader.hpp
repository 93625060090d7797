#pragma once

#include "core/time/velocity_law.hpp"
#include "host/kdl/document.hpp"
#include "host/schema/report.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// A velocity law: a word, or a text such as "steps(4)" or "bezier(0.42, 0, 0.58, 1)", whose numbers are
/// rounded once to 1/8192. What is wrong is reported at its place inside the text.
std::optional<VelocityLaw> read_law(const kdl::Value& value, schema::Report& report);

/// All laws as they are written: "hold", "steps(n)"
std::vector<std::string_view> law_forms();

}
