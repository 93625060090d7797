#pragma once

#include "core/bytes/expects.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace kfast {

/// A text that is stored in place: at most `max` bytes of UTF-8, the rest 0.
template <std::size_t max>
struct StoredText {
    std::array<char, max> bytes{};

    constexpr StoredText() = default;
    /// `text` is no longer than `max`.
    constexpr StoredText(std::string_view text)
    {
        expects(text.size() <= max);
        std::ranges::copy(text, bytes.begin());
    }

    constexpr std::string_view view() const
    {
        const auto end = std::ranges::find(bytes, '\0');
        return {bytes.data(), static_cast<std::size_t>(end - bytes.begin())};
    }

    friend constexpr bool operator==(const StoredText&, const StoredText&) = default;
};

}
