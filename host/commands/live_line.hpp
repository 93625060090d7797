#pragma once

#include "core/input_view.hpp"
#include "firmware/link/message.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// An input that live values may be told to; values are in 1/1000.
struct LiveInput {
    std::string name;
    std::int32_t least = 0;
    std::int32_t most = 0;

    InputView view() const { return {name, least, most, least}; }
    friend bool operator==(const LiveInput&, const LiveInput&) = default;
};

/// What a line of live values says (docs/devices.md): `gaze 0.5 "left lid" 1`. None for an empty line and for
/// a comment. `number` counts from 1. Throws Failure that names the line.
std::vector<link::InputPlace> read_live_line(std::string_view line, std::size_t number,
                                             std::span<const LiveInput> inputs);

}
