#pragma once

#include "firmware/panel/gc9a01.hpp"
#include "firmware/panel/ili9341.hpp"
#include "firmware/panel/ssd0323.hpp"
#include "firmware/panel/ssd1306.hpp"
#include "firmware/panel/ssd1351.hpp"
#include "firmware/panel/st7735.hpp"
#include "firmware/panel/st7789.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace kfast {

/// The controller's row; null if it does not follow MIPI DCS.
template <Controller controller>
constexpr const DcsController* dcs_controller()
{
    if constexpr (requires { PanelDriver<controller>::dcs; })
        return PanelDriver<controller>::dcs;
    else
        return nullptr;
}

template <std::size_t... number>
constexpr std::array<const DcsController*, sizeof...(number)> listed_dcs(std::index_sequence<number...>)
{
    return {dcs_controller<static_cast<Controller>(number)>()...};
}

/// In the order of Controller.
inline constexpr std::array<const DcsController*, controller_count> dcs_controllers =
    listed_dcs(std::make_index_sequence<controller_count>{});

/// Calls `use.template operator()<P>()`, P being the driver of `controller` on such a bus. Those that follow
/// MIPI DCS are what is left after all others, so that the code for their class is there once.
template <DisplayBus Bus, std::size_t first = 0, class Use>
auto with_driver(Controller controller, Use&& use)
{
    if constexpr (first == controller_count) {
        return use.template operator()<DcsPanel<Bus>>();
    } else {
        constexpr auto candidate = static_cast<Controller>(first);
        using P = typename PanelDriver<candidate>::template On<Bus>;
        if constexpr (!std::is_same_v<P, DcsPanel<Bus>>)
            if (controller == candidate)
                return use.template operator()<P>();
        return with_driver<Bus, first + 1>(controller, use);
    }
}

/// The driver `P` of the panel that `settings` describe. `bus` must outlive it.
template <class P, DisplayBus Bus>
P make_panel(Bus& bus, const PanelSettings& settings)
{
    if constexpr (std::constructible_from<P, Bus&, const PanelSettings&>)
        return P{bus, settings};
    else
        return P{bus, settings, *dcs_controllers[static_cast<std::size_t>(settings.controller)]};
}

/// Calls `use(panel)` with the driver of the controller that `settings` names: from a controller chosen at
/// run time to code made for it. The panel is on the stack, an SSD1306 with a kilobyte of pixels, and ends
/// when `use` returns.
template <DisplayBus Bus, class Use>
void with_panel(Bus& bus, const PanelSettings& settings, Use&& use)
{
    with_driver<Bus>(settings.controller, [&]<class P>() {
        P panel = make_panel<P>(bus, settings);
        use(panel);
    });
}

}
