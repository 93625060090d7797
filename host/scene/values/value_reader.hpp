#pragma once

#include "core/scene/kfb_limits.hpp"
#include "core/time/time.hpp"
#include "host/geometry/drawing.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/value_reader.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Values of nodes and properties that only scenes have. Each function reports what is wrong and then returns
/// nothing.
namespace kfast::scene {

using schema::assign;
using schema::place_in_text;
using schema::shortest_text;
using schema::text_of;

inline constexpr Range coordinates{-coordinate_limit, coordinate_limit};
/// Radii, widths and heights.
inline constexpr Range extents{0, 2 * coordinate_limit};
/// Degrees: ten turns either way.
inline constexpr Range angles{-3600, 3600};

/// The limit of values of an input, in whole numbers.
inline constexpr std::int32_t input_limit = kfb::max_input_value / 1000;
inline constexpr Range input_values{-input_limit, input_limit};
/// The number as values of inputs are stored: rounded to nearest, halves away from zero.
std::int32_t thousandths(double number);

/// Frames, or (s) or (ms) by the scene's frame rate; rounded once to 1/1024 frame, halves away from zero.
std::optional<Time> read_time(const kdl::Value& value, SceneContext& context);
/// The same, and it may be negative.
std::optional<Time> read_signed_time(const kdl::Value& value, SceneContext& context);
/// The time in frames, exactly: "60", "7.5"
std::string text_of(Time time);

/// The index among the colours in use.
std::optional<std::size_t> read_colour(const kdl::Value& value, SceneContext& context);
/// Returns false.
bool report_too_many_colours(SourceSpan place, SceneContext& context);
/// `palette` has the colours that there are.
void report_unknown_colour(const kdl::Value& value, std::string_view text, const Palette& palette,
                           SceneContext& context);

inline constexpr std::array loops{
    Word<Loop>{"once", Loop::once},
    Word<Loop>{"repeat", Loop::repeat},
    Word<Loop>{"ping-pong", Loop::ping_pong},
};
std::optional<Loop> read_loop(const kdl::Value& value, SceneContext& context);

}
