#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Boards, cores and displays that people ask for by name and that are not supported: why, and what works
/// instead. Capitals, spaces, dashes and underscores in names do not count.
namespace kfast::fit {

/// What a name represents, for the user who asks for it.
struct OtherName {
    std::string_view names; ///< as they are asked for, with spaces between them: "pico2 pico2w rp2350"
    std::string_view what;  ///< "a Pico 2 (RP2350, Cortex-M33)"
    std::string_view
        hint; ///< the end of the sentence; for a board that can be described, which costs it takes
};

/// A board that has another chip than those that there is firmware for.
struct OtherBoard {
    OtherName name;
    std::string_view core = {}; ///< "cortex-m4 clock=(MHz)150"; empty if no description helps
    std::string_view memory = {};
    std::string_view spi = {};
};

std::span<const OtherBoard> other_boards();
std::span<const OtherName> other_cores();
std::span<const OtherName> other_panels();

/// "a Pico 2 (RP2350, Cortex-M33) is not supported yet"; or which board to take instead.
std::optional<std::string> other_board_text(std::string_view name);
/// The same in several lines, with a description of the board to begin with, if it can be described.
std::optional<std::string> other_board_advice(std::string_view name);
/// The lines that describe it for `kfast fit --board`; empty if none help.
std::string board_file(const OtherBoard& board);
/// The hint for a core whose costs are not known.
std::optional<std::string> other_core_text(std::string_view name);
/// The hint for a display that `kfast fit` does not know.
std::optional<std::string> other_panel_text(std::string_view name);
/// The hint for a display that there is no driver for, though `kfast fit` may know it.
std::optional<std::string> undriven_panel_text(std::string_view name);

/// Small letters and digits alone: "Pico-2 W" is "pico2w".
inline std::string plain_name(std::string_view name)
{
    std::string plain;
    for (const char letter : name)
        if (std::isalnum(static_cast<unsigned char>(letter)) != 0)
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return plain;
}

inline bool is_called(const OtherName& other, std::string_view name)
{
    const std::string plain = ' ' + plain_name(name) + ' ';
    return plain.size() > 2 && (' ' + std::string{other.names} + ' ').find(plain) != std::string::npos;
}

}
