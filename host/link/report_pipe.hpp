#pragma once

#include "firmware/report.hpp"
#include "host/program/failure.hpp"

#include <chrono>
#include <optional>

namespace kfast {

using Milliseconds = std::chrono::milliseconds;

/// Brings reports to a device and back. Its implementation is chosen at run time, hence virtual.
class ReportPipe {
public:
    ReportPipe() = default;
    virtual ~ReportPipe() = default;
    ReportPipe(const ReportPipe&) = delete;
    ReportPipe& operator=(const ReportPipe&) = delete;

    /// Waits while the device is busy. Throws Failure with unplugged, or with timed_out if the device takes
    /// nothing for several seconds.
    virtual void send(const Report& report) = 0;
    /// The next report of the device, for which it waits for `patience`; 0 is possible. What has not the
    /// length of a report is skipped. Throws Failure with unplugged.
    virtual std::optional<Report> receive(Milliseconds patience) = 0;
    /// The time since a fixed time. It never goes back.
    virtual Milliseconds now() const = 0;
};

/// The result of now() for pipes of this computer.
inline Milliseconds steady_milliseconds()
{
    return std::chrono::duration_cast<Milliseconds>(std::chrono::steady_clock::now().time_since_epoch());
}

inline Failure unplugged()
{
    return Failure{"the device is gone: plug it in again, and ask once more", ExitStatus::unplugged};
}

inline Failure takes_nothing()
{
    return Failure{"the device takes no report: unplug it, plug it in again, and ask once more",
                   ExitStatus::timed_out};
}

}
