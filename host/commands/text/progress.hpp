#pragma once

#include "host/program/progress_callback.hpp"

#include <chrono>
#include <cstddef>
#include <string>

namespace kfast {

/// The minimum time between two drawings of a line of progress.
inline constexpr std::chrono::milliseconds between_drawings{100};

/// One line at the end of standard error, if that is a terminal, that is written over and over. It goes away
/// with its owner.
class StatusLine {
public:
    StatusLine();
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    bool is_seen() const { return is_seen_; }
    void show(const std::string& text);

private:
    bool is_seen_;
    std::size_t width_ = 0; ///< of what was shown
};

/// The progress of sending bytes: "[#####               ]  25 %  12.3 KB/s  3 s left". The rate
/// is shown after a while only. `total` is more than 0.
std::string progress_text(std::size_t done, std::size_t total, std::chrono::duration<double> elapsed);

/// The progress of work in steps: "[#####               ]  25 %  3 s left".
std::string work_text(std::size_t done, std::size_t total, std::chrono::duration<double> elapsed);

/// The progress of long work, at the end of a terminal, once it has taken a second.
class WorkBar {
public:
    /// Writes to standard error. `what` comes first: "drawing".
    explicit WorkBar(std::string what) : what_{std::move(what)} {}

    void report(std::size_t done, std::size_t total);
    /// The bar must outlive it.
    ProgressCallback callback()
    {
        return [this](std::size_t done, std::size_t total) { report(done, total); };
    }

private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    StatusLine line_;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point drawn_ = begin_;
};

}
