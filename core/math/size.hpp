#pragma once

namespace kfast {

/// Width and height in whole pixels.
struct Size {
    int width = 0;
    int height = 0;
    friend constexpr bool operator==(Size, Size) = default;
};

/// A rectangle of whole pixels; x and y are its left upper corner.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend constexpr bool operator==(const Rect&, const Rect&) = default;
};

}
