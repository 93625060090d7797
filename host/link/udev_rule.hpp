#pragma once

#include <string_view>

namespace kfast {

/// The file for /etc/udev/rules.d by which users may open devices: 70-kfast.rules.
extern const std::string_view udev_rule;

/// Puts it there.
inline constexpr std::string_view udev_command =
    "kfast devices --udev-rule | sudo tee /etc/udev/rules.d/70-kfast.rules && sudo udevadm control --reload";

}
