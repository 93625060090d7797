#pragma once

#include "firmware/panel/gc9a01.hpp"
#include "firmware/panel/ili9341.hpp"
#include "firmware/panel/ssd0323.hpp"
#include "firmware/panel/ssd1306.hpp"
#include "firmware/panel/ssd1351.hpp"
#include "firmware/panel/st7735.hpp"
#include "firmware/panel/st7789.hpp"

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

/// Calls `use(panel)` with the driver of the controller that `settings` names: from a controller chosen at
/// run time to code made for it. The panel lies on the stack, an SSD1306 with a kilobyte of pixels, and ends
/// when `use` returns.
template <DisplayBus Bus, class Use>
void with_panel(Bus& bus, const PanelSettings& settings, Use&& use)
{
    if (const DcsController* const controller = dcs_controller(settings.controller)) {
        DcsPanel panel{bus, settings, *controller};
        use(panel);
    } else if (settings.controller == Controller::ssd1306) {
        Ssd1306 panel{bus, settings};
        use(panel);
    } else if (settings.controller == Controller::ssd1351) {
        Ssd1351 panel{bus, settings};
        use(panel);
    } else if (settings.controller == Controller::ssd0323) {
        Ssd0323 panel{bus, settings};
        use(panel);
    }
}

}
