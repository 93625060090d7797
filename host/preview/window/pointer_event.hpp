#pragma once

#include <cstdint>

namespace kfast {

/// Something that a mouse did, in pixels of the window; (0, 0) is the left upper one.
struct PointerEvent {
    enum class Kind : std::uint8_t { press, move, release, wheel };
    enum class Button : std::uint8_t { left, other };
    Kind kind = Kind::move;
    int x = 0;
    int y = 0;
    int wheel = 0;                ///< notches, away from the user is positive
    Button button = Button::left; ///< that was pressed or released
};

}
