#pragma once

#include "firmware/chip/microseconds.hpp"
#include "firmware/link/message.hpp"

#include <optional>
#include <utility>

namespace kfast::link {

/// Determines what is to be done when the computer falls silent, and when. It is done once.
class SilenceWatch {
public:
    /// Begins at `now`; 0 milliseconds end it.
    void arm(const Silence& silence, Microseconds now)
    {
        silence_ = silence;
        heard_ = now;
    }
    /// The computer has sent something.
    void hear(Microseconds now) { heard_ = now; }

    /// What is to be done now, because nothing was heard for that long.
    std::optional<SilenceAction> pass(Microseconds now)
    {
        const Microseconds patience{std::uint32_t{1000} * silence_.milliseconds};
        return reached(now, heard_ + patience) ? end() : std::nullopt;
    }
    /// What is to be done now, because nothing will be heard any more.
    std::optional<SilenceAction> end()
    {
        const Silence ended = std::exchange(silence_, {});
        return ended.milliseconds != 0 ? std::optional{ended.action} : std::nullopt;
    }

private:
    Silence silence_;
    Microseconds heard_;
};

}
