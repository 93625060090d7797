#include "host/commands/panel_list.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/commands/flash/settings_choice.hpp"
#include "host/config/setting_words.hpp"
#include "host/fit/display.hpp"
#include "host/picture/panel_choice.hpp"

#include <algorithm>

namespace kfast {
namespace {

std::string buses_of(const ControllerFacts& facts)
{
    std::string buses;
    for (const BusKind bus : {BusKind::spi, BusKind::parallel_8, BusKind::i2c})
        if (facts.takes(bus))
            buses.append(buses.empty() ? "" : ", ").append(config::word_of(bus));
    return buses;
}

/// What the driver of this name reports; fit knows displays that have none.
ListedPanel panel_called(std::string_view name)
{
    const auto choices = panel_choices();
    const auto choice = std::ranges::find(choices, name, &PanelChoice::name);
    if (choice != choices.end()) {
        const ControllerFacts& facts = facts_of(choice->settings.controller);
        return {.name = std::string{name},
                .size = choice->settings.size(),
                .format = facts.format,
                .bus = buses_of(facts),
                .is_drawn = true};
    }
    const fit::Display& display = *fit::display_named(name);
    return {.name = std::string{name}, .size = display.size, .format = display.format, .bus = "spi"};
}

/// "ili9341-parallel" is no controller.
ListedPanel panel_of_settings(const std::string& name)
{
    const BoardSettings settings = ready_settings(name);
    return {.name = name,
            .size = settings.panel.size(),
            .format = facts_of(settings.panel.controller).format,
            .bus = config::word_of(settings.bus),
            .is_flashed = true};
}

}

std::string colours_text(PixelFormat format)
{
    const int bits = bits_per_pixel(format);
    if (bits == 1)
        return "black and white";
    const std::string count = std::to_string(1 << bits);
    return count + (format == PixelFormat::grey4 ? " greys" : " colours");
}

std::vector<ListedPanel> listed_panels()
{
    std::vector<ListedPanel> panels;
    for (const std::string_view name : fit::display_names()) {
        panels.push_back(panel_called(name));
        panels.back().is_fitted = true;
    }
    for (const std::string_view name : ready_panels()) {
        const auto same = std::ranges::find(panels, name, &ListedPanel::name);
        if (same == panels.end())
            panels.push_back(panel_of_settings(std::string{name}));
        else
            same->is_flashed = true;
    }
    std::ranges::sort(panels, {}, &ListedPanel::name);
    return panels;
}

}
