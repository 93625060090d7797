#include "core/player.hpp"
#include "host/fit/board_reader.hpp"
#include "tests/demand.hpp"

#include <cstdint>
#include <string>

using namespace kfast;

namespace {

bool is_panel(const fit::Display& display)
{
    const auto is_side = [](int side, int step) {
        return side >= 1 && side <= Player::max_panel && side % step == 0;
    };
    return is_side(display.size.width, display.granularity.width) &&
           is_side(display.size.height, display.granularity.height);
}

void demand_sense(const fit::Target& target)
{
    demand(!target.name.empty() && !target.processor_name.empty());
    demand(target.clock >= 1e6 && (target.cycles == 0 || target.cycles >= 0.25));
    demand(target.flash >= 1024 && target.ram >= 1024 && target.band_bytes >= 16);
    demand(target.bus.bytes_per_second() > 0);
    demand(target.beam.has_value() == (target.bus.kind == fit::BusKind::dac));
    demand(target.beam || is_panel(target.display));
}

}

/// Any bytes at all: they are refused with messages that can be shown, or describe a board within its ranges.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const SourceText source{.name = "fuzz", .text = std::string(data, data + size)};
    Diagnostics diagnostics;
    const auto target = fit::read_board(source, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.sorted()) {
        demand(diagnostic.place.offset <= source.text.size());
        demand(!format(diagnostic, source).empty());
    }
    demand(target.has_value() == !diagnostics.has_errors());
    if (target)
        demand_sense(*target);
    return 0;
}
