#pragma once

#include "core/kfb_limits.hpp"
#include "core/still.hpp"
#include "firmware/stored_text.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>

namespace kfast {

/// What an input of a scene is to be.
struct ToldText {
    std::uint32_t input = 0; ///< less than SceneView::input_count()
    StoredText<kfb::max_text> text{};
};

/// Texts that were told and have not been passed on yet: of each input the newest one.
class ToldTexts {
public:
    /// `input` is less than kfb::max_inputs; `text` has at most kfb::max_text bytes.
    void tell(std::uint32_t input, std::string_view text)
    {
        texts_[input] = {text};
        waiting_ |= bit_of_input(input);
    }

    std::optional<ToldText> next()
    {
        if (waiting_ == 0)
            return std::nullopt;
        const auto input = static_cast<std::uint32_t>(std::countr_zero(waiting_));
        waiting_ &= waiting_ - 1;
        return ToldText{input, texts_[input]};
    }

    void clear() { waiting_ = 0; }

private:
    std::array<StoredText<kfb::max_text>, kfb::max_inputs> texts_{};
    std::uint32_t waiting_ = 0; ///< a bit for each input
};

}
