#pragma once

#include "firmware/link/checksum.hpp"
#include "firmware/report.hpp"
#include "host/link/report_pipe.hpp"

#include <deque>
#include <functional>
#include <optional>

namespace kfast::test {

/// A device that answers what it is told to.
class ScriptedPipe : public ReportPipe {
public:
    void send(const Report& report) override
    {
        ++now_;
        if (answer)
            if (const auto reply = answer(report)) {
                answers_.push_back(link::with_checksum(*reply));
                if (on_the_way)
                    on_the_way(answers_.back());
            }
    }
    std::optional<Report> receive(Milliseconds patience) override
    {
        if (answers_.empty()) {
            now_ += patience;
            return std::nullopt;
        }
        const Report report = answers_.front();
        answers_.pop_front();
        return report;
    }
    Milliseconds now() const override { return now_; }

    std::function<std::optional<Report>(const Report&)> answer;
    std::function<void(Report&)> on_the_way; ///< what happens to an answer

private:
    std::deque<Report> answers_;
    Milliseconds now_{0};
};

}
