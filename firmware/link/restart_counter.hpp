#pragma once

#include "firmware/chip/microseconds.hpp"
#include "firmware/link/restarts.hpp"

#include <cstdint>
#include <optional>

namespace kfast::link {

/// Keeps what a board must know after its watchdog has restarted it: how often in a row that happened, and
/// what played.
class RestartCounter {
public:
    /// A scene has to play for so long before earlier restarts are forgotten. Most scenes come round in it,
    /// and somebody whose board restarts again and again has the time to choose another scene.
    static constexpr Microseconds trial{60'000'000};

    /// `keep` stores a word that a restart by the watchdog leaves as it is. Null: there is no watchdog.
    RestartCounter(const Restarts& at_start, void (*keep)(std::uint32_t word))
        : keep_{keep}, kept_{.count = at_start.count, .home = Home::start}
    {
        store();
    }

    /// A scene from there begins; start: nothing plays.
    [[gnu::cold]] void begins(Home home, std::uint8_t slot)
    {
        kept_.home = home;
        kept_.slot = slot;
        trial_end_.reset();
        store();
    }

    /// To be called before each frame.
    void pass(Microseconds now)
    {
        if (!trial_end_)
            trial_end_ = now + trial;
        if (kept_.count == 0 || !reached(now, *trial_end_))
            return;
        kept_.count = 0;
        store();
    }

private:
    void store() const
    {
        if (keep_ != nullptr)
            keep_(word_of(kept_));
    }

    void (*keep_)(std::uint32_t);
    Restarts kept_;
    std::optional<Microseconds> trial_end_; ///< none until the scene has its first frame
};

}
