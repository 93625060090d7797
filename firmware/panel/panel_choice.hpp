#pragma once

#include "firmware/panel/gc9a01.hpp"
#include "firmware/panel/ili9341.hpp"
#include "firmware/panel/ssd0323.hpp"
#include "firmware/panel/ssd1306.hpp"
#include "firmware/panel/ssd1351.hpp"
#include "firmware/panel/st7735.hpp"
#include "firmware/panel/st7789.hpp"

#include <concepts>

namespace kfast {

/// Null: it does not follow MIPI DCS.
constexpr const DcsController* dcs_controller(Controller controller)
{
    switch (controller) {
    case Controller::st7789:
        return &st7789;
    case Controller::ili9341:
        return &ili9341;
    case Controller::st7735:
        return &st7735;
    case Controller::gc9a01:
        return &gc9a01;
    case Controller::ssd1306:
    case Controller::ssd1351:
    case Controller::ssd0323:
        break;
    }
    return nullptr;
}

/// Calls `use.template operator()<P>()`, P being the driver of `controller` on such a bus.
template <DisplayBus Bus, class Use>
auto with_driver(Controller controller, Use&& use)
{
    switch (controller) {
    case Controller::st7789:
    case Controller::ili9341:
    case Controller::st7735:
    case Controller::gc9a01:
        break;
    case Controller::ssd1306:
        return use.template operator()<Ssd1306<Bus>>();
    case Controller::ssd1351:
        return use.template operator()<Ssd1351<Bus>>();
    case Controller::ssd0323:
        return use.template operator()<Ssd0323<Bus>>();
    }
    return use.template operator()<DcsPanel<Bus>>();
}

/// The driver `P` of what `settings` describe. `bus` must outlive it.
template <class P, DisplayBus Bus>
P make_panel(Bus& bus, const PanelSettings& settings)
{
    if constexpr (std::constructible_from<P, Bus&, const PanelSettings&>)
        return P{bus, settings};
    else
        return P{bus, settings, *dcs_controller(settings.controller)};
}

/// Calls `use(panel)` with the driver of the controller that `settings` names: from a controller chosen at
/// run time to code made for it. The panel lies on the stack, an SSD1306 with a kilobyte of pixels, and ends
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
