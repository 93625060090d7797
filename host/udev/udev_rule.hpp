#pragma once

#include <string_view>

namespace kfast {

/// The file for /etc/udev/rules.d by which users may open devices and boot loaders: 70-kfast.rules.
extern const std::string_view udev_rule;

/// Puts it there.
inline constexpr std::string_view udev_command = "sudo kfast install-udev";

}
