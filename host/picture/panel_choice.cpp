#include "host/picture/panel_choice.hpp"

#include "firmware/settings/controller_facts.hpp"

#include <algorithm>
#include <array>

namespace kfast {

namespace {

constexpr auto names = [] {
    std::array<FormatName, pixel_formats.size()> rows{};
    std::ranges::transform(pixel_formats, rows.begin(), [](PixelFormat format) {
        return FormatName{name_of(format), format};
    });
    return rows;
}();

constexpr auto choices = [] {
    std::array<PanelChoice, controller_facts.size()> rows{};
    std::ranges::transform(controller_facts, rows.begin(), [](const ControllerFacts& facts) {
        return PanelChoice{controller_name(facts.default_value.controller), facts.default_value};
    });
    return rows;
}();

}

std::span<const FormatName> format_names() { return names; }
std::span<const PanelChoice> panel_choices() { return choices; }

}
