#pragma once

#include "host/picture/picture.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace kfast {

/// A place in a window, in its pixels; y points down, and 0.5 is the middle of the first pixel.
struct WindowSpot {
    double x = 0;
    double y = 0;
};

/// Draws into a window, one thing above the other. What lies outside is not seen.
class Painter {
public:
    /// Pixels of a character, the space around it included.
    static constexpr Size letter{8, 12};

    virtual ~Painter() = default;
    virtual Size size() const = 0;

    virtual void fill(Rect area, Colour colour, std::uint8_t opacity = 255) = 0;
    virtual void line(WindowSpot from, WindowSpot to, Colour colour, std::uint8_t opacity = 255) = 0;
    /// One line of text whose left upper corner is there. A character is a byte of Latin-1.
    virtual void text(int x, int y, std::string_view text, Colour colour) = 0;
    /// Enlarged with hard pixels, shrunk smoothly.
    virtual void picture(const Picture& picture, Rect target) = 0;
    /// What is drawn from now on is seen in `area` only; everywhere if there is none.
    virtual void clip(std::optional<Rect> area) = 0;
};

}
