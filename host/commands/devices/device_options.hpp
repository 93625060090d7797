#pragma once

#include "host/link/remote_device.hpp"
#include "host/program/interruption.hpp"

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// Which devices a command is about, and what it prints.
struct DeviceOptions {
    std::vector<std::string> devices; ///< as for chosen_addresses()
    double timeout = 10;              ///< in seconds
    bool json = false;
    bool quiet = false;
};

/// Adds --device, and what declare_talk_options() adds. `options` must outlive the parsing of `app`.
void declare_device_options(CLI::App& app, DeviceOptions& options);
/// Adds --timeout, --json and --quiet.
void declare_talk_options(CLI::App& app, DeviceOptions& options);

/// What is attached; nothing if the names are those of simulated devices alone.
std::vector<DeviceAddress> attached_for(const std::vector<std::string>& names);

Milliseconds last_patience(const DeviceOptions& options);

/// The devices of a command, which are closed properly when it is interrupted. One object at a time.
class OpenDevices {
public:
    /// Throws what chosen_addresses() and open_device() throw.
    explicit OpenDevices(const DeviceOptions& options);

    std::span<RemoteDevice> all() { return devices_; }

private:
    RememberedInterruption interruption_;
    std::vector<RemoteDevice> devices_;
};

}
