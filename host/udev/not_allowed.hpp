#pragma once

#include "host/program/failure.hpp"

#include <string>
#include <string_view>

namespace kfast {

/// A file of /dev may not be opened. `mark` is what tells the line of udev_rule for it from others.
Failure not_allowed(const std::string& path, std::string_view mark);

}
