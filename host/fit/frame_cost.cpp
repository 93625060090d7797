#include "host/fit/frame_cost.hpp"

#include "host/fit/cost_table.hpp"

namespace kfast::fit {

FrameCost cost_on(const Target& target, const FrameEffort& effort)
{
    const ProcessorCosts& costs = costs_of(target.processor);
    const double cycles = target.cycles != 0 ? target.cycles : costs.cycles;
    const double count = instructions(effort.work, effort.areas, costs);
    return {.moment = effort.moment,
            .instructions = count,
            .cpu_seconds = count * cycles / target.clock,
            .bus_seconds = static_cast<double>(effort.bytes) / target.bus.bytes_per_second(),
            .areas = effort.areas,
            .bytes = effort.bytes};
}

}
