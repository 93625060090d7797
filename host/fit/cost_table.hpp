#pragma once

#include "core/features.hpp"
#include "host/fit/op_counts.hpp"
#include "host/fit/target.hpp"

#include <array>
#include <cstddef>

namespace kfast::fit {

/// What the player costs on a processor. Memory in bytes, as in the images that the benchmark measures.
struct ProcessorCosts {
    std::size_t code = 0;      ///< of the player and its constants, for one pixel format, with every feature
    std::size_t bare_code = 0; ///< without any
    std::array<std::size_t, feature_count> feature_code{}; ///< what each of them adds to that by itself
    std::size_t fixed_ram = 0;           ///< besides the lent block: the player and the loop
    std::size_t stack = 0;               ///< the maximum that was measured
    double cycles = 0;                   ///< for an instruction, on average, from memory without wait states
    double frame = 0;                    ///< instructions for every frame …
    double area = 0;                     ///< … and for every area that is sent
    std::array<double, op_kinds> work{}; ///< instructions for each kind of work
};

/// Found by scripts/calibrate: see docs/fit.md.
const ProcessorCosts& costs_of(Processor processor);

inline double instructions(const OpCounts& work, const ProcessorCosts& costs)
{
    double sum = 0;
    for (std::size_t kind = 0; kind < op_kinds; ++kind)
        sum += work[kind] * costs.work[kind];
    return sum;
}

/// The instructions of a whole frame.
inline double instructions(const OpCounts& work, std::size_t areas, const ProcessorCosts& costs)
{
    return costs.frame + costs.area * static_cast<double>(areas) + instructions(work, costs);
}

}
