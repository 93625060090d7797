#pragma once

#include "tests/bench/phase.hpp"

#include <cstdint>

namespace kfast::bench {

/// Counts the instructions of each phase, exactly. It takes QEMU's `-icount shift=8`, by which every
/// instruction lasts 256 ns, and a timer that ticks every 80 ns, as SysTick of the LM3S6965 does after a
/// reset. A visit to a phase must be shorter than 5.2 million instructions, when the timer comes round.
class InstructionMeter {
public:
    static constexpr bool checks_pixels = true;

    /// Starts the timer and finds what entering a phase costs itself.
    void begin();

    [[gnu::noipa]] void enter(Phase phase);

    /// Since it was asked before.
    PhaseCosts take();

private:
    PhaseCosts costs_{};
    Phase phase_ = Phase::elsewhere;
    std::uint32_t entered_ = 0;
    std::uint32_t own_cost_ = 0;
};

}
