#pragma once

#include "core/math/point.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// Part of a controller's memory and the position in it that the next pixel goes to. Positions are what the
/// controller counts: pixels, bytes of pixels or pages.
class AddressWindow {
public:
    enum class Axis { columns, rows };

    /// Sets one axis, where the last position is `limit` - 1, and goes to the first position of both. Returns
    /// what is wrong with it, and changes nothing then.
    std::optional<std::string> set(Axis axis, int first, int last, int limit);
    /// Goes to the first position.
    void restart();
    /// Goes to the next position, first along `axis`.
    void advance(Axis axis);

    bool is_given() const { return columns_.is_given && rows_.is_given; }
    /// Whether no position is left: the last one was passed.
    bool is_full() const { return is_full_; }
    bool is_begun() const { return is_begun_; }
    int column() const { return columns_.at; }
    int row() const { return rows_.at; }

private:
    struct Stretch {
        int first = 0;
        int last = 0;
        int at = 0;
        bool is_given = false;
    };

    Stretch columns_;
    Stretch rows_;
    bool is_begun_ = false;
    bool is_full_ = false;
};

/// A colour as colour controllers store it, 6 bits a channel; red is what they take for red.
struct StoredColour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
};

/// The top bits of 12 bits, 4 a channel: the lower ones repeat them, so that white is white.
constexpr StoredColour from_rgb444(std::uint32_t bits)
{
    const auto widen = [](std::uint32_t four) { return static_cast<std::uint8_t>(four << 2 | four >> 2); };
    return {widen(bits >> 8 & 15), widen(bits >> 4 & 15), widen(bits & 15)};
}

constexpr StoredColour from_rgb565(std::uint32_t bits)
{
    const auto widen = [](std::uint32_t five) { return static_cast<std::uint8_t>(five << 1 | five >> 4); };
    return {widen(bits >> 11 & 31), static_cast<std::uint8_t>(bits >> 5 & 63), widen(bits & 31)};
}

/// How a glass shows what the controller stores.
struct ColourPath {
    bool swaps = false;   ///< red and blue
    bool inverts = false; ///< all channels

    constexpr std::uint32_t rgb565(StoredColour colour) const
    {
        const std::uint32_t mask = inverts ? 63 : 0;
        const std::uint32_t first = (swaps ? colour.blue : colour.red) ^ mask;
        const std::uint32_t last = (swaps ? colour.red : colour.blue) ^ mask;
        return first >> 1 << 11 | (colour.green ^ mask) << 5 | last >> 1;
    }
};

/// The pixels of a colour controller, not rotated.
class ColourMemory {
public:
    explicit ColourMemory(Size size)
        : width_{size.width},
          pixels_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height))
    {
    }

    StoredColour& at(int column, int row) { return pixels_[static_cast<std::size_t>(row * width_ + column)]; }
    StoredColour at(int column, int row) const
    {
        return pixels_[static_cast<std::size_t>(row * width_ + column)];
    }

private:
    int width_;
    std::vector<StoredColour> pixels_;
};

}
