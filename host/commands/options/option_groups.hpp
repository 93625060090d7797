#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace kfast {

/// The headings under which help, man pages and completions list options, by purpose.
namespace option_group {

inline constexpr const char* what_to_draw =
    "What to draw (one of these; default: frame 0, or all of an animation or a video)";
inline constexpr const char* what_to_make = "What to make (one of these)";
inline constexpr const char* output = "Where to write it, and how";
inline constexpr const char* contents = "What to put on the board";
inline constexpr const char* play = "What to play";
inline constexpr const char* showing = "How to show it";
inline constexpr const char* board = "The board";
inline constexpr const char* display = "The display";
inline constexpr const char* wires = "Its wires";
inline constexpr const char* device = "Which device (docs/devices.md)";
inline constexpr const char* boot = "Its boot loader (docs/flash.md)";
inline constexpr const char* inputs = "Inputs of the scene";
inline constexpr const char* imports = "Files of other programs (docs/import.md)";
inline constexpr const char* key_drawings = "Key drawings of SVG (docs/import-svg.md)";
inline constexpr const char* beam = "Vector displays (docs/beam.md)";
inline constexpr const char* sound = "Sound that leads an oscilloscope (docs/beam.md)";
inline constexpr const char* unseen = "Without a window";
inline constexpr const char* report = "What to print";

/// In this order; what has no heading of its own comes last.
inline constexpr std::array<std::string_view, 18> in_order{
    what_to_draw, what_to_make, output, contents,     play,    showing, board, display, wires,
    device,       boot,         inputs, key_drawings, imports, beam,    sound, unseen,  report};

}

/// While it lives, what is added to `app` is under this heading.
class OptionHeading {
public:
    OptionHeading(CLI::App& app, const char* group) : app_{app}, before_{*app.option_defaults()}
    {
        app.option_defaults()->group(group);
    }
    ~OptionHeading() { *app_.option_defaults() = std::move(before_); }
    OptionHeading(const OptionHeading&) = delete;
    OptionHeading& operator=(const OptionHeading&) = delete;

private:
    CLI::App& app_;
    CLI::OptionDefaults before_;
};

/// By which headings are sorted.
inline std::size_t place_of_group(std::string_view group)
{
    return static_cast<std::size_t>(std::ranges::find(option_group::in_order, group) -
                                    option_group::in_order.begin());
}

}
