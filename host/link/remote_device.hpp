#pragma once

#include "host/link/device_address.hpp"
#include "host/link/report_pipe.hpp"
#include "host/link/session.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// A device that has answered, and whose answers are understood.
class RemoteDevice {
public:
    /// Throws what Session throws, and Failure with wrong_version. `name` is for messages if it has no
    /// serial number.
    RemoteDevice(std::unique_ptr<ReportPipe> pipe, const Session::Options& options, const std::string& name);

    Session& session() { return session_; }
    /// Its capabilities when it was opened.
    const link::Capabilities& capabilities() const { return capabilities_; }
    /// The serial number, or another name; fit for a terminal.
    const std::string& name() const { return name_; }

private:
    std::unique_ptr<ReportPipe> pipe_;
    Session session_;
    link::Capabilities capabilities_;
    std::string name_;
};

/// Throws Failure with no_device or no_permission, and what RemoteDevice throws.
RemoteDevice open_device(const DeviceAddress& address, Milliseconds last_patience);

/// Calls `act` for every device and its index at the same time, each on a thread of its own, and returns when
/// all have ended. What some of them throw is thrown as one Failure, with the names of the devices if there
/// are several; its status is that of the first.
void on_each(std::span<RemoteDevice> devices, const std::function<void(RemoteDevice&, std::size_t)>& act);

}
