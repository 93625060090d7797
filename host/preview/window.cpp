#include "host/preview/window.hpp"

#include "host/preview/picture_window.hpp"
#include "host/preview/steady_now.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

constexpr double redraws_per_second = 60;

int milliseconds_to_redraw()
{
    const double redraws = steady_now().count() * redraws_per_second;
    return std::max(1, static_cast<int>((std::floor(redraws) + 1 - redraws) * 1000 / redraws_per_second));
}

/// Sleeps until there is something to do. True when the window is to be drawn anew.
bool take_events(PictureWindow& window, Playback& playback)
{
    const auto events = window.take_events(playback.playing() ? milliseconds_to_redraw() : 1000);
    for (const PreviewKey key : events.keys)
        playback.press(key, steady_now());
    return events.any;
}

void draw(PictureWindow& window, FrameSource& source, const Playback& playback)
{
    const auto help = playback.help_open() ? preview_key_help() : std::vector<std::string>{};
    const Frame& frame = show(source, playback);
    window.draw(frame, status_of(source, playback), help);
}

void play(PictureWindow& window, FrameSource& source, Playback& playback)
{
    draw(window, source, playback);
    while (!playback.wants_to_quit()) {
        const Time shown = playback.time();
        const bool disturbed = take_events(window, playback);
        playback.advance_to(steady_now());
        if (disturbed || playback.time() != shown)
            draw(window, source, playback);
    }
}

}

bool play_in_window(FrameSource& source, const Programme& programme, const std::string& title,
                    std::optional<int> loops)
{
    const auto window = PictureWindow::open(title, source.show(Time{0}).size);
    if (!window)
        return false;
    Playback playback{programme, source.pace(), steady_now(), loops};
    play(*window, source, playback);
    return true;
}

}
