#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace kfast::scene {

/// How a label writes a number, as in "##0.0 km/h".
struct NumberPattern {
    std::uint32_t decimals = 0;
    std::uint32_t digits = 1; ///< before the point: at least so many, with zeros in front
    std::uint32_t places = 0; ///< likewise, with gaps in front of the digits; 0 without gaps
    char32_t point = U'.';
    std::u32string before;
    std::u32string behind;
};

/// Reads a text; reports what is wrong.
std::optional<NumberPattern> read_number_pattern(const kdl::Value& value, SceneContext& context);

}
