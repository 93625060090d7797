#pragma once

#include "host/commands/live/live_line.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/report_pipe.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace kfast {

/// Reads lines as they come, without waiting for more than is there.
class LineSource {
public:
    /// Of an open file, which stays open.
    explicit LineSource(int descriptor) : descriptor_{descriptor} {}

    /// The next line without its end, for which it waits that long. The last one need not have an end. Throws
    /// Failure when a line is longer than any that is valid.
    std::optional<std::string> next(Milliseconds patience);
    /// Whether nothing more will come.
    bool is_over() const { return has_ended_ && buffer_.empty(); }
    /// The number of the line that came last, counted from 1.
    std::size_t number() const { return number_; }

private:
    void read_more(Milliseconds patience);
    std::optional<std::string> buffered_line();

    int descriptor_;
    std::string buffer_;
    std::size_t number_ = 0;
    bool has_ended_ = false;
};

/// What a device does when no more values come.
enum class Afterwards {
    go_on,
    hold,
    back, ///< to the scene of its start
};

struct StreamOptions {
    std::optional<double> rate; ///< lines a second; none: as they come
    Afterwards afterwards = Afterwards::go_on;
    Milliseconds silence{1000}; ///< after which a device assumes that this computer is gone
};

/// Sends the values from standard input to all devices, until it ends. `inputs` are those of what plays
/// there. Throws what Session throws, Refusal, and Failure for a wrong line; the devices are left as asked
/// even then.
void stream_live(std::span<RemoteDevice> devices, std::span<const LiveInput> inputs,
                 const StreamOptions& stream_options);

}
