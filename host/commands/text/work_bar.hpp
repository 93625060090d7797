#pragma once

#include "host/commands/text/status_line.hpp"
#include "host/program/progress_callback.hpp"

#include <chrono>
#include <string>

namespace kfast {

/// How far something long has come, at the end of a terminal: from the second on that it takes.
class WorkBar {
public:
    /// To standard error. `what` stands in front: "drawing".
    explicit WorkBar(std::string what) : what_{std::move(what)} {}

    void report(std::size_t done, std::size_t total);
    /// The bar must outlive it.
    ProgressCallback callback()
    {
        return [this](std::size_t done, std::size_t total) { report(done, total); };
    }

private:
    using Driver = std::chrono::steady_clock;

    std::string what_;
    StatusLine line_;
    Driver::time_point begin_ = Driver::now();
    Driver::time_point drawn_ = begin_;
};

}
