#pragma once

#include "core/input_view.hpp"
#include "firmware/link/message.hpp"
#include "host/told_drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// An input that live values may be told to; those of a number are in 1/1000.
struct LiveInput {
    std::string name;
    std::int32_t least = 0;
    std::int32_t most = 0;
    InputType type = InputType::number;

    InputView view() const { return {.name = name, .least = least, .most = most, .usual = least}; }
    friend bool operator==(const LiveInput&, const LiveInput&) = default;
};

/// A drawing, and the number of the input that it is for.
struct LiveDrawingLine {
    std::uint8_t input = 0;
    ToldDrawing drawing;
};

/// What a line says that begins with the name of a drawing: `plot 10,20 30,40 / 50,60`. None for any other
/// line. Throws as read_live_line() does.
std::optional<LiveDrawingLine> read_live_drawing(std::string_view line, std::size_t number,
                                                 std::span<const LiveInput> inputs);

/// What a line of live values says (docs/devices.md): `gaze 0.5 "left lid" 1`. None for an empty line and for
/// a comment. `number` counts from 1. Throws Failure that names the line.
std::vector<link::InputPlace> read_live_line(std::string_view line, std::size_t number,
                                             std::span<const LiveInput> inputs);

}
