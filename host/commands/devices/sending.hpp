#pragma once

#include "firmware/link/message_kind.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/commands/text/progress.hpp"
#include "host/compile/scene_file.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/scene_upload.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// One line at the end of a terminal that shows the progress of sending bytes to devices, to all of them
/// together. It goes away with the bar.
class ProgressBar {
public:
    enum class Shown { no, on_a_terminal };

    /// Writes to standard error. `bytes` go to each of `devices`. `what` comes first: "writing ".
    ProgressBar(std::size_t bytes, std::size_t devices, Shown shown, std::string what = {});
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// The callback for what goes to one of the devices; may be called from any thread.
    ByteProgressCallback of_device(std::size_t index);

private:
    using Clock = std::chrono::steady_clock;

    void report(std::size_t index, std::size_t bytes);
    void draw(std::size_t done);

    std::mutex mutex_;
    std::vector<std::size_t> done_; ///< bytes of each device
    std::size_t total_;
    StatusLine line_;
    bool is_shown_;
    Clock::time_point begin_;
    Clock::time_point drawn_;
    std::string what_; ///< comes first
};

inline ProgressBar::Shown shown_progress(const DeviceOptions& options)
{
    return options.quiet || options.json ? ProgressBar::Shown::no : ProgressBar::Shown::on_a_terminal;
}

/// A scene that is in the RAM of all devices. It may have replaced what played before.
class SentScene {
public:
    /// Sends it, with a progress bar if the options allow it. Throws what upload_scene() throws; then it is
    /// taken back from the devices that have it already, and they play what they played before.
    SentScene(const SceneFile& scene, std::span<RemoteDevice> devices, const DeviceOptions& options);

    /// Plays it on a device, or only one of its clips. Throws what Session throws, and Refusal; then it is
    /// taken back.
    void play(std::size_t device, const link::Name& clip) const;

private:
    std::span<RemoteDevice> devices_;
    std::vector<std::optional<std::uint8_t>> tags_; ///< of the uploads
};

}
