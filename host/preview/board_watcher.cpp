#include "host/preview/board_watcher.hpp"

#include "host/preview/panes/picture_pane.hpp"
#include "host/preview/panes/text_box.hpp"
#include "host/preview/window/window_layout.hpp"
#include "host/text/characters.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

namespace kfast {
namespace {

std::string place_text(const link::Playing& playing)
{
    switch (playing.home) {
    case link::Home::slot:
        return "slot " + std::to_string(playing.slot);
    case link::Home::ram:
        return "RAM";
    default:
        return "built-in scene";
    }
}

/// "slot 2  frame 12.5  paused  clip blink".
std::string status_text(Time moment, const link::Playing& playing)
{
    std::ostringstream text;
    text << place_text(playing) << "  frame " << std::fixed << std::setprecision(1) << in_frames(moment);
    if (playing.is_paused)
        text << "  paused";
    if (!playing.clip.view().empty())
        text << "  clip " << visible(playing.clip.view());
    return text.str();
}

}

BoardWatcher::BoardWatcher(std::unique_ptr<PictureWindow> window, std::ostream* out,
                           std::function<bool()> is_over)
    : window_{std::move(window)}, out_{out}, is_over_{std::move(is_over)}
{
}

void BoardWatcher::see(const Frame& picture, Time moment, const link::Playing& playing)
{
    keep(picture, status_text(moment, playing));
    if (out_ == nullptr)
        return;
    std::ostringstream line;
    line << "frame " << in_frames(moment) << ' ' << std::hex << std::setw(8) << std::setfill('0')
         << hash(picture) << '\n';
    *out_ << line.str() << std::flush;
}

void BoardWatcher::hear(const EventView& event)
{
    if (out_ != nullptr)
        *out_ << "event " << visible(event.name) << '\n' << std::flush;
}

void BoardWatcher::see_nothing(const Frame& picture, std::string_view why)
{
    keep(picture, "nothing plays: " + std::string{why});
    if (out_ != nullptr)
        *out_ << status_ << '\n' << std::flush;
}

bool BoardWatcher::has_seen_enough()
{
    if (window_ == nullptr)
        return is_over_();
    const PictureWindow::Events events = window_->take_events(0);
    is_closed_ = is_closed_ || events.is_closed || std::ranges::any_of(events.keys, [](PreviewKey key) {
                     return key == PreviewKey::quit || key == PreviewKey::leave;
                 });
    if (events.any && !last_.pixels.empty())
        draw();
    return is_closed_ || is_over_();
}

void BoardWatcher::keep(const Frame& picture, const std::string& status)
{
    last_ = picture;
    status_ = status;
    if (window_ != nullptr)
        draw();
}

void BoardWatcher::draw()
{
    const Picture picture = widen(last_);
    window_->draw([&](Painter& painter) {
        const WindowLayout parts = window_layout(painter.size(), {});
        draw_picture(painter, picture, {picture.size, parts.picture, 0}, {});
        draw_status(painter, parts.status, status_);
    });
}

}
