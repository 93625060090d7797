#pragma once

#include "core/scene/input_view.hpp"
#include "host/link/live_feed.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// An input that live values may set.
struct LiveInput {
    std::string name;
    InputType type = InputType::number;
    std::int32_t min = 0;                ///< of a number, in 1/1000
    std::int32_t max = 0;                ///< of a number, in 1/1000; of a text, characters
    std::optional<GlyphSet> glyphs = {}; ///< of a text, in the bytes of the scene, if they are known

    InputView view() const { return {.name = name, .min = min, .max = max, .default_value = min}; }
    /// As far as devices report it.
    bool is_like(const LiveInput& other) const
    {
        return name == other.name && type == other.type && min == other.min && max == other.max;
    }
};

/// What a line of live values says (docs/devices.md): `gaze 0.5 "left lid" 1 label "12:45"`, or
/// `plot 10,20 30,40 / 50,60`. Nothing for an empty line and for a comment. `number` counts from 1. Throws
/// Failure that names the line.
LiveValues read_live_line(std::string_view line, std::size_t number, std::span<const LiveInput> inputs);

}
