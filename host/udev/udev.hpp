#pragma once

#include "host/program/failure.hpp"

#include <string>
#include <string_view>

namespace kfast {

/// The file for /etc/udev/rules.d by which users may open devices and boot loaders: 70-kfast.rules.
extern const std::string_view udev_rule;

/// Puts it there: "sudo kfast install-udev", with the folder of this program where root would not find it.
std::string udev_command();

/// A file of /dev may not be opened. `mark` is what tells the line of udev_rule for it from others.
Failure not_allowed(const std::string& path, std::string_view mark);

}
