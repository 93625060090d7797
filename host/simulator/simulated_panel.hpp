#pragma once

#include "firmware/panel/ssd0323.hpp"
#include "host/simulator/simulated_bus.hpp"

#include <array>
#include <concepts>

namespace kfast {

/// The controllers that with_simulated_panel() knows a driver of.
inline constexpr std::array simulated_controllers{Controller::ssd0323};

/// Calls `use.template operator()<P>()`, P being the firmware's driver of `controller` on a simulated bus.
template <class Use>
auto with_simulated_panel(Controller, Use use)
{
    return use.template operator()<Ssd0323<SimulatedBus>>();
}

/// The driver of what `settings` describe. `bus` must outlive it.
template <class P>
P simulated_panel(SimulatedBus& bus, const PanelSettings& settings)
{
    if constexpr (std::constructible_from<P, SimulatedBus&, const PanelSettings&>)
        return P{bus, settings};
    else
        return P{bus};
}

}
