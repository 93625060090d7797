#pragma once

#include "host/link/device_address.hpp"
#include "host/link/report_pipe.hpp"

#include <memory>
#include <vector>

namespace kfast {

/// All devices that are plugged in by USB, in the order of their serial numbers. Needs no permission.
std::vector<DeviceAddress> attached_devices();

/// Throws Failure with no_permission or no_device.
std::unique_ptr<ReportPipe> open_hid_pipe(const DeviceAddress& address);

}
