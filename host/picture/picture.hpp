#pragma once

#include "core/pixel/paint_style.hpp"
#include "host/picture/frame.hpp"

#include <vector>

namespace kfast {

/// An image for the PC: 8 bits a channel, rows from the top without gaps.
struct Picture {
    Size size;
    std::vector<Colour> pixels;

    const Colour& at(int x, int y) const
    {
        const int index = y * size.width + x;
        return pixels[static_cast<std::size_t>(index)];
    }
};

/// Every channel v of at most max becomes (v * 255 + max / 2) div max.
Picture widen(const Frame& frame);

}
