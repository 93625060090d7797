#pragma once

#include "host/picture/frame.hpp"
#include "host/preview/preview_key.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// A window that shows pictures of one size, magnified or shrunk to it, with a line of text below.
class PictureWindow {
public:
    /// Null where there can be none: no_window() says why. Throws Failure if a window cannot be opened all
    /// the same.
    static std::unique_ptr<PictureWindow> open(const std::string& title, Size picture);
    /// Why open() is null, as a part of a sentence.
    static const char* no_window();
    virtual ~PictureWindow() = default;

    /// With `help` in a box above the picture, if there is any.
    virtual void draw(const Frame& frame, const std::string& status, std::span<const std::string> help) = 0;

    struct Events {
        bool any = false; ///< the window is to be drawn anew
        std::vector<PreviewKey> keys;
    };
    /// What happened since the last call; waits for something, but not longer than `milliseconds`. Whoever
    /// closes the window presses PreviewKey::quit.
    virtual Events take_events(int milliseconds) = 0;

protected:
    PictureWindow() = default;
};

}
