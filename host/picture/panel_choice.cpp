#include "host/picture/panel_choice.hpp"

#include "firmware/controller_facts.hpp"
#include "host/simulator/simulated_panel.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

constexpr auto choices = [] {
    std::array<PanelChoice, simulated_controllers.size()> rows{};
    std::ranges::transform(simulated_controllers, rows.begin(), [](Controller controller) {
        return PanelChoice{controller_names[static_cast<std::size_t>(controller)],
                           facts_of(controller).usual};
    });
    return rows;
}();

}

std::span<const PanelChoice> panel_choices() { return choices; }

}
