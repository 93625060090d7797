#include "host/preview/controls/view_options.hpp"

#include "host/preview/controls/zoom_steps.hpp"

#include <array>

namespace kfast {
namespace {

struct Switch {
    PreviewKey key;
    bool ViewOptions::*value;
    const char* on;
};

constexpr std::array switches{
    Switch{PreviewKey::onion_skin, &ViewOptions::onion_skin, "onion skin"},
    Switch{PreviewKey::bones, &ViewOptions::bones, "bones"},
    Switch{PreviewKey::numbers, &ViewOptions::numbers, "numbers"},
    Switch{PreviewKey::changed_areas, &ViewOptions::changed_areas, "changed areas"},
    Switch{PreviewKey::panel_frame, &ViewOptions::panel_frame, "panel frame"},
    Switch{PreviewKey::fit_report, &ViewOptions::fit_report, "fit report"},
    Switch{PreviewKey::time_line, &ViewOptions::time_line, "time line"},
};

}

void press(ViewOptions& view, PreviewKey key)
{
    if (key == PreviewKey::zoom_in)
        view.zoom = next_larger_zoom(view.zoom);
    else if (key == PreviewKey::zoom_out)
        view.zoom = view.zoom <= 1 ? 0 : next_smaller_zoom(view.zoom);
    for (const Switch& row : switches)
        if (row.key == key)
            view.*row.value = !(view.*row.value);
}

std::string in_words(const ViewOptions& view)
{
    const ViewOptions at_first;
    std::string words;
    for (const Switch& row : switches)
        if (view.*row.value != at_first.*row.value)
            words.append(view.*row.value ? "  " : "  no ").append(row.on);
    if (view.zoom != at_first.zoom)
        words += "  zoom " + std::to_string(view.zoom);
    return words;
}

}
