#pragma once

#include "core/math/point.hpp"
#include "host/picture/picture.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace kfast {

constexpr bool is_empty(const Rect& area) { return area.width <= 0 || area.height <= 0; }

constexpr int right_of(const Rect& area) { return area.x + area.width; }
constexpr int bottom_of(const Rect& area) { return area.y + area.height; }

constexpr bool contains(const Rect& area, int x, int y)
{
    return x >= area.x && x < right_of(area) && y >= area.y && y < bottom_of(area);
}

/// The intersection of both; of no size if there is none.
constexpr Rect common(const Rect& a, const Rect& b)
{
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    return {x, y, std::max(0, std::min(right_of(a), right_of(b)) - x),
            std::max(0, std::min(bottom_of(a), bottom_of(b)) - y)};
}

/// Without a margin on each side; of no size if nothing is left.
constexpr Rect inset(const Rect& area, int horizontal, int vertical)
{
    return {area.x + horizontal, area.y + vertical, std::max(0, area.width - 2 * horizontal),
            std::max(0, area.height - 2 * vertical)};
}
constexpr Rect inset(const Rect& area, int margin) { return inset(area, margin, margin); }

/// A point in a window, in its pixels; y points down, and 0.5 is the middle of the first pixel.
struct WindowSpot {
    double x = 0;
    double y = 0;
};

constexpr WindowSpot middle_of(const Rect& area)
{
    return {area.x + area.width / 2.0, area.y + area.height / 2.0};
}

/// Draws into a window, one thing above the other. What is outside is not visible. Colours that are not
/// opaque are blended over what was drawn before.
class Painter {
public:
    /// The pixels of a character, including the space around it.
    static constexpr Size letter{7, 16};

    virtual ~Painter() = default;
    virtual Size size() const = 0;

    virtual void fill(Rect area, Colour colour) = 0;
    /// A closed polygon with smooth edges; what it encloses twice is filled, too.
    virtual void polygon(std::span<const WindowSpot> corners, Colour colour) = 0;
    /// One line of UTF-8 whose left upper corner is there; every code point is as wide as `letter`.
    virtual void text(int x, int y, std::string_view text, Colour colour) = 0;
    /// A picture, enlarged with hard pixels, shrunk smoothly.
    virtual void picture(const Picture& picture, Rect target) = 0;
    /// What is drawn from now on is visible in `area` only; everywhere if there is none.
    virtual void clip(std::optional<Rect> area) = 0;
};

/// While it lives, only what is drawn within an area is visible.
class Clipped {
public:
    Clipped(Painter& painter, Rect area) : painter_{painter} { painter.clip(area); }
    ~Clipped() { painter_.clip(std::nullopt); }
    Clipped(const Clipped&) = delete;
    Clipped& operator=(const Clipped&) = delete;

private:
    Painter& painter_;
};

/// `width` pixels wide, with flat ends.
void draw_line(Painter& painter, WindowSpot from, WindowSpot to, double width, Colour colour);
void draw_disc(Painter& painter, WindowSpot centre, double radius, Colour colour);
void draw_diamond(Painter& painter, WindowSpot centre, double radius, Colour colour);
/// Its corners are quarters of circles; `radius` is at most half of each side.
void draw_round_rect(Painter& painter, Rect area, double radius, Colour colour);
/// One pixel wide, within the area.
void draw_frame(Painter& painter, Rect area, Colour colour);
void draw_ring(Painter& painter, WindowSpot centre, double inner, double outer, Colour colour);
/// Fills the part of a square that is outside of the circle in it.
void fill_corners(Painter& painter, Rect square, Colour colour);

}
