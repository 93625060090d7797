#include "host/picture/panel_choice.hpp"

#include "firmware/settings/controller_facts.hpp"

#include <algorithm>
#include <array>

namespace kfast {

namespace {

constexpr std::array names{
    FormatName{"rgb565", PixelFormat::rgb565},
    FormatName{"rgb565_be", PixelFormat::rgb565_be},
    FormatName{"rgb444", PixelFormat::rgb444},
    FormatName{"rgb666", PixelFormat::rgb666},
    FormatName{"grey4", PixelFormat::grey4},
    FormatName{"mono1", PixelFormat::mono1},
    FormatName{"mono1_dithered", PixelFormat::mono1_dithered},
};

}

std::span<const FormatName> format_names() { return names; }

std::string_view name_of(PixelFormat format)
{
    return std::ranges::find(names, format, &FormatName::value)->name;
}

namespace {

constexpr auto choices = [] {
    std::array<PanelChoice, controller_facts.size()> rows{};
    std::ranges::transform(controller_facts, rows.begin(), [](const ControllerFacts& facts) {
        return PanelChoice{controller_name(facts.default_value.controller), facts.default_value};
    });
    return rows;
}();

}

std::span<const PanelChoice> panel_choices() { return choices; }

}
