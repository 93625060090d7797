#pragma once

#include "core/bytes/expects.hpp"
#include "core/pose/input_drawing.hpp"
#include "core/scene/input_view.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/time/time.hpp"
#include "firmware/link/message_kind.hpp"
#include "firmware/report.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

/// The messages about the inputs of the scene that plays (message.hpp).
namespace kfast::link {

struct AskInput {
    static constexpr Kind kind = Kind::input;
    std::uint8_t input = 0; ///< its number in the scene that plays

    static constexpr void fields(auto&& io, auto& it) { io(it.input); }
};

/// The kinds of inputs of a scene.
enum class InputKind : std::uint8_t {
    number = 0,
    text = 1,
    drawing = 2,
};
/// A later device may have more of them.
constexpr bool is_known(InputKind) { return true; }
constexpr InputKind input_kind(InputType type) { return static_cast<InputKind>(type); }
static_assert(input_kind(InputType::number) == InputKind::number &&
              input_kind(InputType::text) == InputKind::text &&
              input_kind(InputType::drawing) == InputKind::drawing);

/// One input of the scene that plays. Values, which only a number has, are in 1/1000; for a text only `max`
/// counts, in characters.
struct InputState {
    static constexpr Kind kind = Kind::input;
    static constexpr bool answers = true;
    std::uint8_t input = 0;
    InputKind takes = InputKind::number;
    Name name{}; ///< its first 24 bytes, in whole letters
    std::int32_t min = 0;
    std::int32_t max = 0;
    std::int32_t default_value = 0; ///< until another is set
    Time place{};                   ///< its value: 0 … whole_input

    static constexpr void fields(auto&& io, auto& it)
    {
        io(it.input, it.takes, it.name, it.min, it.max, it.default_value, it.place);
    }
};

struct InputPlace {
    std::uint8_t input = 0; ///< its number in the scene
    Time place{};           ///< 0 … whole_input (core/time/time.hpp)

    static constexpr void fields(auto&& io, auto& it) { io(it.input, it.place); }
    friend constexpr bool operator==(const InputPlace&, const InputPlace&) = default;
};

/// Sets values of inputs of the scene that plays.
struct Inputs {
    static constexpr Kind kind = Kind::inputs;
    static constexpr std::size_t max = 12;
    std::uint8_t count = 0;
    std::array<InputPlace, max> places{};

    /// Whether there are no more than `max`, and each has a value that an input can have. Their numbers may
    /// still be none of the scene's.
    constexpr bool is_valid() const
    {
        const auto is_place = [](const InputPlace& each) {
            return each.place >= Time{0} && each.place <= whole_input;
        };
        return count <= max && std::ranges::all_of(std::span{places}.first(count), is_place);
    }

    static constexpr void fields(auto&& io, auto& it) { io(it.count, it.places); }
};

/// Sets a text among the inputs of the scene that plays.
struct Text {
    static constexpr Kind kind = Kind::text;
    static constexpr std::size_t max = payload_bytes - 2;
    std::uint8_t input = 0;             ///< its number in the scene
    std::uint8_t length = 0;            ///< bytes
    std::array<std::byte, max> bytes{}; ///< in UTF-8

    /// `length` is at most `max`.
    std::string_view view() const
    {
        expects(length <= max);
        return {reinterpret_cast<const char*>(bytes.data()), length};
    }

    static constexpr void fields(auto&& io, auto& it) { io(it.input, it.length, it.bytes); }
};

/// Which drawing the points belong to: a drawing among the inputs of the scene that plays, and a number that
/// distinguishes it from the ones before.
struct DrawingNumber {
    static constexpr std::uint8_t count = 8; ///< numbers go round

    std::uint8_t input = 0; ///< below kfb::max_inputs
    std::uint8_t number = 0;

    static constexpr DrawingNumber of(std::uint8_t code)
    {
        return {static_cast<std::uint8_t>(code % kfb::max_inputs),
                static_cast<std::uint8_t>(code / kfb::max_inputs)};
    }
    constexpr std::uint8_t code() const
    {
        return static_cast<std::uint8_t>(input + number * kfb::max_inputs);
    }
    friend constexpr bool operator==(DrawingNumber, DrawingNumber) = default;
};
static_assert(kfb::max_inputs * DrawingNumber::count == 256);

/// Replaces a point: the next one begins a stroke.
inline constexpr InputPoint pen_up{std::numeric_limits<std::int16_t>::min(), 0};

/// Points of a drawing, in their order: part 0 begins it.
struct Points {
    static constexpr Kind kind = Kind::points;
    static constexpr std::size_t max = 15;
    std::uint8_t which = 0; ///< DrawingNumber
    std::uint8_t part = 0;  ///< how many come before, modulo 256
    std::array<InputPoint, max> points{};

    static constexpr void fields(auto&& io, auto& it) { io(it.which, it.part, it.points); }
};

/// The last points of a drawing, which is to be shown.
struct Drawing {
    static constexpr Kind kind = Kind::drawing;
    static constexpr std::size_t max = 14;
    std::uint8_t which = 0;  ///< DrawingNumber
    std::uint8_t part = 0;   ///< how many come before, modulo 256
    std::uint16_t count = 0; ///< of all points of the drawing and of those replaced by pen_up
    std::array<InputPoint, max> points{};

    static constexpr void fields(auto&& io, auto& it) { io(it.which, it.part, it.count, it.points); }
};

/// How many reports a drawing with `count` points, including pen_up, takes.
constexpr std::size_t reports_of_drawing(std::size_t count)
{
    return count <= Drawing::max ? 1 : 1 + (count - Drawing::max + Points::max - 1) / Points::max;
}

}
