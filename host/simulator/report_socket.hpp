#pragma once

#include "firmware/link/link_service.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace kfast {

/// The plug of a simulated board: a socket at which programs send it reports and receive its own. As with a
/// plug, all of them receive every report.
class ReportSocket {
public:
    /// Throws Failure if the socket cannot be made, or a board listens there already.
    explicit ReportSocket(std::filesystem::path path);
    ~ReportSocket();
    ReportSocket(const ReportSocket&) = delete;
    ReportSocket& operator=(const ReportSocket&) = delete;

    /// Sleeps until a report may have come, but not longer than `time`.
    void wait(std::chrono::microseconds time);

    // What LinkService requires (link::Pipe).
    /// The next report. What does not have the length of a report is dropped.
    std::optional<Report> take();
    /// A program that does not fetch reports misses them.
    bool send(const Report& report);
    /// It is always plugged in.
    bool is_connected() const { return true; }
    std::uint32_t connections() const { return 0; }

private:
    void accept_all();

    std::filesystem::path path_;
    int listener_;
    std::vector<int> programs_;
};

}
