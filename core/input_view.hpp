#pragma once

#include "core/byte_reader.hpp"
#include "core/clock.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

/// A number that a scene takes from outside, and that keys may go by; borrows the scene's bytes. Values are
/// in 1/1000.
struct InputView {
    std::string_view name; ///< UTF-8
    std::int32_t least = 0;
    std::int32_t most = 0;  ///< more than `least`
    std::int32_t usual = 0; ///< until another is told

    /// Where the input stands with `value`, held within its range; rounded to nearest, halves up.
    Time place_of(std::int32_t value) const;
};

/// Reads the inputs of a scene in their order.
class InputCursor {
public:
    InputCursor(ByteReader bytes, std::uint32_t count) : bytes_{bytes}, left_{count} {}

    bool at_end() const { return left_ == 0; }
    /// Only when not at the end. What has another kind than a number is past the end.
    InputView next();
    /// What has not been read.
    const ByteReader& rest() const { return bytes_; }

private:
    ByteReader bytes_;
    std::uint32_t left_;
};

/// Puts into `places` where the inputs stand until others are told; there are as many of both.
void put_usual_places(InputCursor inputs, std::span<Time> places);

}
