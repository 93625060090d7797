#pragma once

#include "host/lottie/shapes/shapes.hpp"

#include <string_view>

namespace kfast::lottie {

/// Reports the members of a shape of that type "ty" that nothing reads. Those of types that are not known are
/// not looked at.
void report_unknown_members(const Json& item, std::string_view type, const Reading& reading);

}
