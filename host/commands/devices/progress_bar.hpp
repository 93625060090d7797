#pragma once

#include "host/commands/devices/device_options.hpp"
#include "host/commands/text/status_line.hpp"
#include "host/link/scene_upload.hpp"

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace kfast {

/// One line at the end of a terminal that says how far something has come that brings bytes to devices, to
/// all of them together. It goes away with the bar.
class ProgressBar {
public:
    enum class Shown { no, on_a_terminal };

    /// To standard error. `bytes` go to each of so many devices. `what` stands in front: "writing ".
    ProgressBar(std::size_t bytes, std::size_t devices, Shown shown, std::string what = {});
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// For what goes to one of the devices; may be called from any thread.
    ByteProgressCallback of_device(std::size_t index);

private:
    using Driver = std::chrono::steady_clock;

    void report(std::size_t index, std::size_t bytes);
    void draw(std::size_t done);

    std::mutex mutex_;
    std::vector<std::size_t> done_; ///< bytes of each device
    std::size_t total_;
    StatusLine line_;
    bool is_shown_;
    Driver::time_point begin_;
    Driver::time_point drawn_;
    std::string what_; ///< stands in front
};

inline ProgressBar::Shown shown_progress(const DeviceOptions& options)
{
    return options.quiet || options.json ? ProgressBar::Shown::no : ProgressBar::Shown::on_a_terminal;
}

}
