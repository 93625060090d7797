#pragma once

#include "host/picture/picture.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace kfast {

/// A place in a window, in its pixels; y points down, and 0.5 is the middle of the first pixel.
struct WindowSpot {
    double x = 0;
    double y = 0;
};

constexpr WindowSpot middle_of(const Rect& area)
{
    return {area.x + area.width / 2.0, area.y + area.height / 2.0};
}

/// Draws into a window, one thing above the other. What lies outside is not seen. Colours that are not
/// opaque let shine through what was drawn before.
class Painter {
public:
    /// Pixels of a character, the space around it included.
    static constexpr Size letter{7, 16};

    virtual ~Painter() = default;
    virtual Size size() const = 0;

    virtual void fill(Rect area, Colour colour) = 0;
    /// A closed polygon with smooth edges; what it encloses twice is filled, too.
    virtual void polygon(std::span<const WindowSpot> corners, Colour colour) = 0;
    /// One line of UTF-8 whose left upper corner is there; every code point is as wide as `letter`.
    virtual void text(int x, int y, std::string_view text, Colour colour) = 0;
    /// Enlarged with hard pixels, shrunk smoothly.
    virtual void picture(const Picture& picture, Rect target) = 0;
    /// What is drawn from now on is seen in `area` only; everywhere if there is none.
    virtual void clip(std::optional<Rect> area) = 0;
};

/// While it lives, only what is drawn within an area is seen.
class Clipped {
public:
    Clipped(Painter& painter, Rect area) : painter_{painter} { painter.clip(area); }
    ~Clipped() { painter_.clip(std::nullopt); }
    Clipped(const Clipped&) = delete;
    Clipped& operator=(const Clipped&) = delete;

private:
    Painter& painter_;
};

}
