#include "host/preview/window.hpp"

#include "host/preview/playback/preview_playback.hpp"
#include "host/preview/window/preview_screen.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace kfast {
namespace {

using Seconds = Viewer::Seconds;

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

class PreviewWindow {
public:
    PreviewWindow(PictureWindow& window, Viewer& viewer) : window_{window}, viewer_{viewer} {}

    void play()
    {
        draw();
        while (!viewer_.wants_to_quit()) {
            const Time shown = viewer_.playback().time();
            const bool is_disturbed = take_events();
            const Seconds now = steady_now();
            const bool has_changed = viewer_.attend(now) || viewer_.playback().time() != shown;
            const bool too_soon = viewer_.is_working() && now - drawn_ < Seconds{0.05};
            if ((is_disturbed || has_changed || screen_.is_outdated(now)) && !too_soon)
                draw();
        }
    }

private:
    void draw()
    {
        drawn_ = steady_now();
        show_title();
        window_.draw([this](Painter& painter) { screen_.draw(painter, viewer_, drawn_); });
    }

    void show_title()
    {
        std::string title = viewer_.scene().file.filename().string() + " - kfast preview";
        if (title == title_)
            return;
        title_ = std::move(title);
        window_.set_title(title_);
    }

    /// Sleeps until there is something to do. Returns true when the window must be drawn anew.
    bool take_events()
    {
        const auto events = window_.take_events(patience(viewer_));
        const Seconds now = steady_now();
        for (const PreviewKey key : events.keys)
            screen_.press(key, viewer_, now);
        for (const PointerEvent& event : events.pointer)
            screen_.touch(event, viewer_, now);
        if (!events.dropped.empty())
            viewer_.open(events.dropped.back(), now);
        if (events.is_closed)
            viewer_.close();
        return events.any;
    }

    PictureWindow& window_;
    Viewer& viewer_;
    PreviewScreen screen_;
    Seconds drawn_{};
    std::string title_;
};

}

Size first_window_size(Size panel)
{
    constexpr Size default_size{960, 720};
    constexpr Size beside{320, 260};
    return {std::max(default_size.width, panel.width + beside.width),
            std::max(default_size.height, panel.height + beside.height)};
}

void play_in_window(PictureWindow& window, Viewer& viewer) { PreviewWindow{window, viewer}.play(); }

}
