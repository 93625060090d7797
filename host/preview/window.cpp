#include "host/preview/window.hpp"

#include "host/preview/steady_now.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

constexpr double redraws_per_second = 60;
constexpr int looks_at_files = 250; // milliseconds

int milliseconds_to_redraw()
{
    const double redraws = steady_now().count() * redraws_per_second;
    return std::max(1, static_cast<int>((std::floor(redraws) + 1 - redraws) * 1000 / redraws_per_second));
}

int patience(const Viewer& viewer)
{
    if (viewer.is_working())
        return 0;
    return viewer.playback().playing() ? milliseconds_to_redraw() : looks_at_files;
}

/// Sleeps until there is something to do. True when the window is to be drawn anew.
bool take_events(PictureWindow& window, Viewer& viewer)
{
    const auto events = window.take_events(patience(viewer));
    for (const PreviewKey key : events.keys)
        viewer.press(key, steady_now());
    return events.any;
}

void draw(PictureWindow& window, Viewer& viewer)
{
    std::vector<std::string> help =
        viewer.playback().help_open() ? preview_key_help() : std::vector<std::string>{};
    if (!viewer.errors().empty())
        help = viewer.errors();
    window.draw(viewer.frame(), viewer.notice().empty() ? viewer.status() : viewer.notice(), help);
}

}

void play_in_window(PictureWindow& window, Viewer& viewer)
{
    draw(window, viewer);
    Playback::Seconds drawn = steady_now();
    while (!viewer.wants_to_quit()) {
        const Time shown = viewer.playback().time();
        bool is_due = take_events(window, viewer);
        is_due = viewer.attend(steady_now()) || is_due || viewer.playback().time() != shown;
        const bool too_soon = viewer.is_working() && steady_now() - drawn < Playback::Seconds{0.05};
        if (!is_due || too_soon)
            continue;
        draw(window, viewer);
        drawn = steady_now();
    }
}

}
