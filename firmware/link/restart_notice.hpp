#pragma once

#include "firmware/link/restarts.hpp"
#include "firmware/run/board.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace kfast::link {

/// What the display of a board says at a start in safe mode.
class RestartNotice {
public:
    [[gnu::cold]] explicit constexpr RestartNotice(const Restarts& restarts)
    {
        if (!restarts.is_safe_mode())
            return;
        const std::string_view words = words_for(restarts.home);
        size_ = words.size();
        std::ranges::copy(words, text_.begin());
        if (restarts.home == Home::slot)
            *std::ranges::find(text_, '0') = static_cast<char>('0' + restarts.slot % 10);
    }

    /// No title: it has nothing to say. The notice refers to this.
    constexpr Notice notice() const
    {
        return size_ == 0 ? Notice{} : Notice{"safe mode", {text_.data(), size_}};
    }

private:
    static constexpr std::string_view words_for(Home home)
    {
        using namespace std::string_view_literals; // of known length: nothing calls strlen
        switch (home) {
        case Home::slot:
            return "slot 0 hung: it is not played"sv;
        case Home::ram:
            return "a scene in RAM hung"sv;
        case Home::built_in:
            return "the built-in scene hung: nothing plays"sv;
        default:
            return "it hung before it played: nothing plays"sv;
        }
    }

    std::array<char, 48> text_{};
    std::size_t size_ = 0;
};

}
