#pragma once

#include "core/pose/input_drawing.hpp"
#include "core/time/time.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

/// The inputs of a scene that is shown somewhere: each member as the one of Player.
class InputReceiver {
public:
    virtual ~InputReceiver() = default;

    virtual void set_input(std::uint32_t number, Time place) = 0;
    virtual bool set_drawing(std::uint32_t number, std::span<const InputStroke> strokes) = 0;
    virtual void set_text(std::uint32_t number, std::string_view text) = 0;
};

}
