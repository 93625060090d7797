#pragma once

#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace kfast {

/// How to reach a device that has not been opened yet.
struct DeviceAddress {
    enum class Way { usb, socket };

    Way way = Way::usb;
    std::string path;
    std::string serial; ///< only for USB; a simulated board reports it when it is asked
};

/// Its name in messages.
inline std::string name_of(const DeviceAddress& address)
{
    return address.serial.empty() ? address.path : address.serial;
}

/// Where a simulated board listens unless it is given another path: a socket of SOCK_SEQPACKET, over which
/// reports of 64 bytes go in both directions. Each user has one.
inline std::string sim_socket_path()
{
    const char* const folder = std::getenv("XDG_RUNTIME_DIR");
    if (folder != nullptr && *folder != '\0')
        return std::string{folder} + "/kfast-sim.sock";
    return "/tmp/kfast-" + std::to_string(::getuid()) + "-sim.sock";
}

/// `sim` or `sim:PATH`
bool is_simulated(std::string_view name);

/// The devices with these names, each once: by serial number; `all` that are attached; `sim` or
/// `sim:PATH`, a simulated board. Without any name, the only one that is attached.
///
/// Throws Failure with no_device if there is none or not that one, and with wrong_usage if there are several
/// and none is named.
std::vector<DeviceAddress> chosen_addresses(std::span<const std::string> names,
                                            std::span<const DeviceAddress> attached);

}
