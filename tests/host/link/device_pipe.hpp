#pragma once

#include "firmware/report.hpp"
#include "host/link/report_pipe.hpp"
#include "tests/firmware/link/bad_pipe.hpp"
#include "tests/firmware/link/link_bench.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace kfast::test {

/// A pipe to a device in this program, whose time passes by a millisecond for each report that is sent and as
/// long as somebody waits.
class DevicePipe : public ReportPipe {
public:
    /// The device must outlive it.
    explicit DevicePipe(LinkBench& device, const Badness& badness = {}, std::uint32_t seed = 1)
        : device_{device}, there_{badness, seed}, back_{badness, seed + 1}
    {
    }

    void send(const Report& report) override
    {
        require_plugged();
        sent.push_back(report);
        if (on_sent)
            on_sent(report);
        if (const auto left = on_the_way ? on_the_way(report) : report)
            there_.put(*left);
        pass();
    }
    std::optional<Report> receive(Milliseconds patience) override
    {
        for (const Milliseconds end = now_ + patience;; pass()) {
            require_plugged();
            if (const auto report = next())
                return report;
            if (now_ >= end)
                return std::nullopt;
        }
    }
    Milliseconds now() const override { return now_; }

    static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

    std::size_t unplugged_after = never; ///< so many reports, of those that come as well as of those that go
    Milliseconds::rep answers_every = 1; ///< milliseconds
    bool is_silent = false;              ///< the device answers nothing
    std::function<void(const Report&)> on_sent;
    /// What becomes of a report, besides what the badness does.
    std::function<std::optional<Report>(const Report&)> on_the_way;
    std::vector<Report> sent;

private:
    void require_plugged() const
    {
        if (sent.size() + received_ >= unplugged_after)
            throw unplugged();
    }

    void pass()
    {
        now_ += Milliseconds{1};
        device_.wait(1);
        while (const auto bytes = there_.next())
            device_.link.take(*bytes, device_.now);
        if (now_.count() % answers_every != 0)
            return;
        if (const auto report = device_.link.next_report(); report && !is_silent)
            back_.put(*report);
    }

    std::optional<Report> next()
    {
        while (const auto bytes = back_.next()) {
            if (bytes->size() != report_bytes)
                continue;
            ++received_;
            Report report;
            std::ranges::copy(*bytes, report.bytes.begin());
            return report;
        }
        return std::nullopt;
    }

    LinkBench& device_;
    BadPipe there_;
    BadPipe back_;
    std::size_t received_ = 0;
    Milliseconds now_{0};
};

}
