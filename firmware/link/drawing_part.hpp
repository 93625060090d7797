#pragma once

#include "core/pose/input_drawing.hpp"
#include "firmware/link/input_message.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace kfast::link {

/// What one report contains of a drawing.
struct DrawingPart {
    DrawingNumber which{};
    std::uint8_t part = 0;                ///< how many come before, modulo 256
    std::optional<std::uint16_t> count{}; ///< of the whole drawing; only with the last part
    std::span<const InputPoint> points{}; ///< also pen_up; in the last part, with what is no part of it
};

}
