#pragma once

#include <cstdlib>
#include <string>
#include <unistd.h>

namespace kfast {

/// Where a simulated board listens unless it is given another place: a socket of SOCK_SEQPACKET, over which
/// reports of 64 bytes go both ways. Each user has one.
inline std::string sim_socket_path()
{
    const char* const folder = std::getenv("XDG_RUNTIME_DIR");
    if (folder != nullptr && *folder != '\0')
        return std::string{folder} + "/kfast-sim.sock";
    return "/tmp/kfast-" + std::to_string(::getuid()) + "-sim.sock";
}

}
