#pragma once

#include "core/bytes/result.hpp"
#include "firmware/run/notice_card.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace kfast {

/// E and the number of an error as large as the panel allows, and what it means in words where there is room:
/// what a panel of at least 9 x 7 pixels, 13 x 7 for numbers of two digits, shows when nothing can be played.
/// A smaller one stays black.
class FaultCard {
public:
    FaultCard(Error error, Size panel) : number_{number_of(error)}, card_{number(), error_text(error), panel}
    {
    }
    FaultCard(const FaultCard&) = delete;

    /// What it looks like.
    const NoticeCard& notice() const { return card_; }

    template <PixelFormat format>
    void draw_row(PixelRow<format> row) const
    {
        card_.draw_row(row);
    }

private:
    /// The text of a number of one or two digits.
    static constexpr std::array<char, 3> number_of(Error error)
    {
        const auto digit = [](int value) { return static_cast<char>('0' + value); };
        const int code = static_cast<int>(error);
        if (code < 10)
            return {'E', digit(code)};
        return {'E', digit(code / 10), digit(code % 10)};
    }
    std::string_view number() const { return {number_.data(), number_[2] == 0 ? std::size_t{2} : 3}; }

    std::array<char, 3> number_;
    NoticeCard card_;
};

}
