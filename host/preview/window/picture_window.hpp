#pragma once

#include "host/preview/controls/preview_key.hpp"
#include "host/preview/painter/painter.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace kfast {

/// A mouse event, in pixels of the window; (0, 0) is the left upper one.
struct PointerEvent {
    enum class Kind : std::uint8_t { press, move, release, wheel };
    enum class Button : std::uint8_t { left, other };
    Kind kind = Kind::move;
    int x = 0;
    int y = 0;
    int wheel = 0;                ///< notches, away from the user is positive
    Button button = Button::left; ///< the one that was pressed or released
};

/// A window of the desktop, which can be resized. Its contents come from a Painter, and it reports the events
/// of its user.
class PictureWindow {
public:
    /// `size` is the wanted one; it is reduced to that of the screen. Returns null where there can be no
    /// window: no_window() says why. Throws Failure if a window cannot be opened all the same.
    static std::unique_ptr<PictureWindow> open(const std::string& title, Size size);
    /// Whether open() does not return null.
    static bool can_open();
    /// Why open() returns null, as a part of a sentence.
    static const char* no_window();
    virtual ~PictureWindow() = default;

    virtual void set_title(const std::string& title) = 0;
    /// Calls `paint` once for all of the window, which is at least 1 pixel wide and high.
    virtual void draw(const std::function<void(Painter&)>& paint) = 0;

    struct Events {
        bool any = false; ///< whether the window must be drawn anew
        bool is_closed = false;
        std::vector<PreviewKey> keys;
        std::vector<PointerEvent> pointer;
        std::vector<std::filesystem::path> dropped; ///< files
    };
    /// The events since the last call; waits for some, but not longer than `milliseconds`.
    virtual Events take_events(int milliseconds) = 0;

protected:
    PictureWindow() = default;
};

}
