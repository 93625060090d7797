#pragma once

#include "core/math/point.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast {

/// The display controllers that firmware/panel/ has drivers for; each is a row in controller_facts.hpp.
/// Stored: numbers do not change.
enum class Controller : std::uint8_t { st7789, ili9341, st7735, gc9a01, ssd1306, ssd1351, ssd0323 };

inline constexpr std::size_t controller_count = static_cast<std::size_t>(Controller::ssd0323) + 1;

/// How far the picture is rotated on the glass, clockwise, relative to how the controller scans it.
/// Stored.
enum class Rotation : std::uint8_t { none, quarter, half, three_quarters };

/// Whether a picture that is rotated so is across the glass: its width is the glass's height.
constexpr bool lies_across(Rotation rotation)
{
    return rotation == Rotation::quarter || rotation == Rotation::three_quarters;
}

/// One glass on its controller.
struct PanelSettings {
    Controller controller = Controller::st7789;
    Size glass{240, 240}; ///< pixels, not rotated
    /// Where the glass begins in the controller's memory, not rotated.
    int column = 0;
    int row = 0;
    Rotation rotation = Rotation::none;
    bool bgr = false;            ///< the glass has blue where the controller assumes red
    bool inverted = false;       ///< the glass shows colours inverted unless the controller inverts them too
    bool tearing_effect = false; ///< the controller signals on its TE line when it has shown a picture
    std::uint8_t brightness = 255;

    /// The size of the picture: the glass as it is rotated.
    constexpr Size size() const { return lies_across(rotation) ? Size{glass.height, glass.width} : glass; }

    friend constexpr bool operator==(const PanelSettings&, const PanelSettings&) = default;
};

}
