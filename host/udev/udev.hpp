#pragma once

#include "host/program/failure.hpp"

#include <string>
#include <string_view>

namespace kfast {

/// The file for /etc/udev/rules.d by which users may open devices and boot loaders: 70-kfast.rules.
extern const std::string_view udev_rule;

/// Puts it there: "sudo kfast install-udev", with the folder of this program where root would not find it.
std::string udev_command();

/// The failure that a file of /dev may not be opened. `mark` identifies the line of udev_rule for it.
Failure not_allowed(const std::string& path, std::string_view mark);

}
