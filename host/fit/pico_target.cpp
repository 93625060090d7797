#include "host/fit/pico_target.hpp"

#include "host/fit/board_choice.hpp"

namespace kfast::fit {
namespace {

BusKind kind_of(kfast::BusKind bus)
{
    switch (bus) {
    case kfast::BusKind::spi:
        return BusKind::spi;
    case kfast::BusKind::i2c:
        return BusKind::i2c;
    case kfast::BusKind::parallel_8:
        return BusKind::parallel_8;
    case kfast::BusKind::dac:
        break;
    }
    return {};
}

}

Target pico_target(const BoardSettings& settings)
{
    if (leads_beam(settings.bus)) {
        Target target = chosen_board("pico-xy");
        target.beam = settings.beam;
        target.bus.clock = settings.bus_clock;
        return target;
    }
    Target target = chosen_board("pico");
    target.display = *display_named(controller_name(settings.panel.controller));
    target.display.size = settings.panel.size();
    target.bus = {kind_of(settings.bus), static_cast<double>(settings.bus_clock)};
    return target;
}

}
