#pragma once

#include "firmware/panel/bus.hpp"
#include "firmware/settings/panel_settings.hpp"

namespace kfast {

/// What drives a controller on a bus is the class `PanelDriver<controller>::On<Bus>`. The file of the driver
/// says so, and panel_choice.hpp includes them all. Of a controller that follows MIPI DCS, `dcs` is the
/// DcsController that the class is given (DcsDriver).
template <Controller controller>
struct PanelDriver;

}
