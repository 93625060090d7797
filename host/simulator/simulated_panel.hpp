#pragma once

#include "firmware/panel_choice.hpp"
#include "host/simulator/simulated_bus.hpp"

#include <concepts>

namespace kfast {

/// Calls `use.template operator()<P>()`, P being the firmware's driver of `controller` on a simulated bus.
template <class Use>
auto with_simulated_panel(Controller controller, Use use)
{
    switch (controller) {
    case Controller::st7789:
    case Controller::ili9341:
    case Controller::st7735:
    case Controller::gc9a01:
        return use.template operator()<DcsPanel<SimulatedBus>>();
    case Controller::ssd1306:
        return use.template operator()<Ssd1306<SimulatedBus>>();
    case Controller::ssd1351:
        return use.template operator()<Ssd1351<SimulatedBus>>();
    case Controller::ssd0323:
        break;
    }
    return use.template operator()<Ssd0323<SimulatedBus>>();
}

/// The driver of what `settings` describe. `bus` must outlive it.
template <class P>
P simulated_panel(SimulatedBus& bus, const PanelSettings& settings)
{
    if constexpr (std::constructible_from<P, SimulatedBus&, const PanelSettings&>)
        return P{bus, settings};
    else
        return P{bus, settings, *dcs_controller(settings.controller)};
}

}
