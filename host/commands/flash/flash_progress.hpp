#pragma once

#include "host/commands/devices/progress_bar.hpp"
#include "host/flash/flashing.hpp"

#include <optional>

namespace kfast {

/// How far flashing has come, on standard error: a bar for each phase on a terminal, else a line when it
/// begins.
class FlashProgress {
public:
    explicit FlashProgress(ProgressBar::Shown shown) : shown_{shown} {}

    void report(FlashPhase phase, std::size_t done, std::size_t total);

private:
    void begin(FlashPhase phase, std::size_t total);

    ProgressBar::Shown shown_;
    std::optional<FlashPhase> phase_;
    std::optional<ProgressBar> bar_;
};

}
