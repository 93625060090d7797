#include "host/fit/cost_table.hpp"

namespace kfast::fit {
namespace {

constexpr std::array<ProcessorCosts, processor_count> table{};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

double instructions(const WorkCount& work, const ProcessorCosts& costs)
{
    double sum = 0;
    for (std::size_t kind = 0; kind < work_kinds; ++kind)
        sum += work[kind] * costs.work[kind];
    return sum;
}

}
