#pragma once

#include "tests/bench/phase.hpp"

#include <cstdint>

namespace kfast::bench {

/// In the place of InstructionMeter: tells now and then where the program is, and "shown" after every frame.
///
///     p <address of the next instruction>
class Sampler {
public:
    static constexpr bool checks_pixels = false;

    /// Of 80 ns each; 3.2 of them are an instruction. A prime, so that no loop of the program beats with it.
    static constexpr std::uint32_t period_ticks = 641;

    /// Samples are taken in the phases that count.
    [[gnu::noipa]] void enter(Phase phase);
    PhaseCosts take();
};

}
