#pragma once

#include "host/link/remote_device.hpp"

#include <cstddef>
#include <functional>
#include <span>

namespace kfast {

/// Calls `act` for every device and its index at the same time, each on a thread of its own, and returns when
/// all have ended. What some of them throw is thrown as one Failure, with the names of the devices if there
/// are several; its status is that of the first.
void on_each(std::span<RemoteDevice> devices, const std::function<void(RemoteDevice&, std::size_t)>& act);

}
