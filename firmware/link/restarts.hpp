#pragma once

#include "firmware/link/message_kind.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace kfast::link {

/// How often in a row the watchdog has restarted a board, and what played before the last restart.
struct Restarts {
    std::uint8_t count = 0;      ///< 0: it was started in another way
    Home home = Home::built_in;  ///< one of the first three; start: no scene had begun
    std::uint8_t slot = no_slot; ///< if it was one

    /// Whether the board plays nothing by itself that may be the reason: neither the chosen slot, nor, unless
    /// allows_built_in(), its built-in scene.
    constexpr bool is_safe_mode() const { return count >= 2; }
    /// Whether the built-in scene is above suspicion.
    constexpr bool allows_built_in() const
    {
        return !is_safe_mode() || home == Home::slot || home == Home::ram;
    }

    static constexpr void fields(auto&& io, auto& it) { io(it.count, it.home, it.slot); }
};

namespace kept_word {

/// In the upper half, as no other program leaves it there.
inline constexpr std::uint32_t magic = 0x4B46;
inline constexpr std::uint32_t max_count = 15;

}

/// The word in which a board keeps them for the time after its next restart.
constexpr std::uint32_t word_of(const Restarts& restarts)
{
    const std::uint32_t count = std::min<std::uint32_t>(restarts.count, kept_word::max_count);
    return kept_word::magic << 16 | count << 12 | static_cast<std::uint32_t>(restarts.home) << 8 |
           restarts.slot;
}

/// What word_of() was given, with at most 15 restarts; nothing if `word` is of somebody else.
constexpr std::optional<Restarts> restarts_in(std::uint32_t word)
{
    const auto home = static_cast<Home>(word >> 8 & 15);
    if (word >> 16 != kept_word::magic || !is_known(home))
        return std::nullopt;
    return Restarts{.count = static_cast<std::uint8_t>(word >> 12 & 15),
                    .home = home,
                    .slot = static_cast<std::uint8_t>(word & 255)};
}

/// Those of a board that starts: `word` is what it has kept, if a restart by the watchdog is what it was
/// kept for.
constexpr Restarts restarts_at_start(std::uint32_t word, bool is_by_watchdog)
{
    auto restarts = restarts_in(word);
    if (!is_by_watchdog || !restarts)
        return {};
    ++restarts->count;
    return *restarts;
}

}
