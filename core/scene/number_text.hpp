#pragma once

#include "core/scene/input_view.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/time/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A number as a label writes it: the numbers of its glyphs (docs/format.md, "Live items").
class NumberText {
public:
    NumberText() = default;
    /// The value of `input`, a number, at `place` (0 … whole_input): min + (max - min) x place / whole_input,
    /// rounded once to the decimals of `format`, halves away from 0. `format` is valid.
    NumberText(const NumberFormat& format, const InputView& input, Time place);

    std::span<const std::byte> glyphs() const { return std::span{glyphs_}.subspan(first_); }

private:
    void put_before(std::uint32_t glyph) { glyphs_[--first_] = static_cast<std::byte>(glyph); }
    void put_before(std::span<const std::byte> glyphs);
    std::uint32_t put_number_before(const NumberFormat& format, std::uint32_t number);

    std::array<std::byte, kfb::max_text>
        glyphs_{}; ///< from `first_` on; written from the last one to the first
    std::size_t first_ = kfb::max_text;
};

/// The most glyphs that a number of this input has: those of an end of its range.
std::uint32_t max_glyphs(const NumberFormat& format, const InputView& input);

}
