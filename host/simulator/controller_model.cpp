#include "host/simulator/controller_model.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/program/failure.hpp"
#include "host/simulator/dcs_model.hpp"
#include "host/simulator/ssd0323_model.hpp"
#include "host/simulator/ssd1306_model.hpp"
#include "host/simulator/ssd1351_model.hpp"

namespace kfast {
namespace {

std::string text_of(Size size) { return std::to_string(size.width) + 'x' + std::to_string(size.height); }

void check_glass(const PanelSettings& settings)
{
    const Size memory = facts_of(settings.controller).memory;
    const auto fits = [](int first, int count, int all) {
        return first >= 0 && count > 0 && first + count <= all;
    };
    if (!fits(settings.column, settings.glass.width, memory.width) ||
        !fits(settings.row, settings.glass.height, memory.height))
        throw Failure("a glass of " + text_of(settings.glass) + " at column " +
                      std::to_string(settings.column) + ", row " + std::to_string(settings.row) +
                      " does not lie within the memory of the controller, " + text_of(memory));
}

}

std::unique_ptr<ControllerModel> make_controller_model(const PanelSettings& settings)
{
    check_glass(settings);
    switch (settings.controller) {
    case Controller::st7789:
    case Controller::ili9341:
    case Controller::st7735:
    case Controller::gc9a01:
        return std::make_unique<DcsModel>(settings);
    case Controller::ssd1306:
        return std::make_unique<Ssd1306Model>(settings);
    case Controller::ssd1351:
        return std::make_unique<Ssd1351Model>(settings);
    case Controller::ssd0323:
        return std::make_unique<Ssd0323Model>(settings);
    }
    return nullptr;
}

}
