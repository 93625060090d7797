#pragma once

#include <string>
#include <string_view>

namespace kfast {

/// The file for /etc/udev/rules.d by which users may open devices and boot loaders: 70-kfast.rules.
extern const std::string_view udev_rule;

/// Puts it there: "sudo kfast install-udev", with the folder of this program where root would not find it.
std::string udev_command();

}
