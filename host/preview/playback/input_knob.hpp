#pragma once

#include "core/scene/input_view.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace kfast {

/// An input of a scene that is no drawing; if it is a number, keys turn it. Values are in 1/1000.
struct InputKnob {
    std::string name;
    std::uint32_t number = 0; ///< of the input
    InputView range;          ///< without its name
    std::int32_t value = 0;
    std::string text = {};  ///< only of a text
    bool is_turned = false; ///< by a person, since the scene was opened

    bool can_turn() const { return range.type == InputType::number; }

    /// By a twentieth of its range for each step.
    void turn(int steps)
    {
        const std::int64_t step = std::max((std::int64_t{range.max} - range.min) / 20, std::int64_t{1});
        is_turned = true;
        put(value + steps * step);
    }

    /// As near as its range allows.
    void put(std::int64_t wanted)
    {
        value =
            static_cast<std::int32_t>(std::clamp(wanted, std::int64_t{range.min}, std::int64_t{range.max}));
    }

    Time place() const { return range.place_of(value); }
};

}
