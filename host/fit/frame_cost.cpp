#include "host/fit/frame_cost.hpp"

#include "host/fit/cost_table.hpp"
#include "host/walk/outline_items.hpp"

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

LargestOutlines outlines_of(Time moment, const raster::Picture& picture)
{
    LargestOutlines outlines{.moment = moment, .bytes = picture.outlines.needed_bytes()};
    for (const auto& [path, bytes] : outline_bytes_by_item(picture))
        if (bytes > outlines.item_bytes) {
            outlines.path = path;
            outlines.item_bytes = bytes;
        }
    return outlines;
}

}
