#pragma once

#include "core/beam/field_point.hpp"
#include "core/square_root.hpp"

#include <cstdint>
#include <cstdlib>

namespace kfast {

/// A way within the field.
struct FieldVector {
    std::int32_t x = 0; ///< within ±65535, as y
    std::int32_t y = 0;

    /// In units of the field, rounded up, and up to 2 units more if it is longer than half the field.
    std::uint32_t length() const
    {
        const auto width = static_cast<std::uint32_t>(std::abs(x));
        const auto height = static_cast<std::uint32_t>(std::abs(y));
        constexpr std::uint32_t half = field_most; // two squares of it fit in 32 bits
        return width <= half && height <= half ? length_of(width, height)
                                               : 2 * length_of((width + 1) / 2, (height + 1) / 2);
    }

private:
    static std::uint32_t length_of(std::uint32_t width, std::uint32_t height)
    {
        if (width == 0 || height == 0)
            return width + height;
        const std::uint32_t square = width * width + height * height;
        const std::uint32_t root = square_root(square);
        return root * root == square ? root : root + 1;
    }
};

constexpr FieldVector operator-(FieldPoint to, FieldPoint from) { return {to.x - from.x, to.y - from.y}; }

}
