#pragma once

#include "host/link/device_address.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// `sim` or `sim:PATH`
bool is_simulated(std::string_view name);

/// The devices that are asked for, each once: by serial number; `all` that are attached; `sim` or
/// `sim:PATH`, a simulated board. Without any name, the only one that is attached.
///
/// Throws Failure with no_device if there is none or not that one, and with wrong_usage if there are several
/// and none is named.
std::vector<DeviceAddress> chosen_addresses(std::span<const std::string> names,
                                            std::span<const DeviceAddress> attached);

}
