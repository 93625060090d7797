#pragma once

#include "host/commands/live/live_line.hpp"
#include "host/link/remote_device.hpp"

#include <optional>
#include <span>

namespace kfast {

/// What a device does when no more values come.
enum class Afterwards {
    go_on,
    hold,
    back, ///< to the scene of its start
};

struct StreamOptions {
    std::optional<double> rate; ///< lines a second; none: as they come
    Afterwards afterwards = Afterwards::go_on;
    Milliseconds silence{1000}; ///< after which a device takes this computer for gone
};

/// Sends the values that standard input tells to all devices, until it ends. `inputs` are those of what plays
/// there. Throws what Session throws, Refusal, and Failure for a wrong line; the devices are left as asked
/// even then.
void stream_live(std::span<RemoteDevice> devices, std::span<const LiveInput> inputs,
                 const StreamOptions& stream_options);

}
