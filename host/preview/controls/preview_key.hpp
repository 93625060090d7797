#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// What a user can ask of a preview with one key.
enum class PreviewKey {
    play_pause,
    next_key,
    previous_key,
    next_frame,
    previous_frame,
    faster,
    slower,
    reverse,
    next_clip,
    previous_clip,
    next_input,
    more_input,
    less_input,
    travel,
    read_file,
    all_frames,
    loop,
    onion_skin,
    bones,
    numbers,
    changed_areas,
    panel_frame,
    fit_report,
    time_line,
    quantities,
    board_speed,
    zoom_in,
    zoom_out,
    next_item,
    previous_item,
    edit,
    screenshot,
    gif,
    help,
    leave, ///< the help if it is open, otherwise the preview
    quit
};

/// Where a preview is shown.
enum class PreviewFront {
    window,
    terminal,
};

/// `name` as in preview_key_help(); "?" is the help, too.
std::optional<PreviewKey> preview_key(std::string_view name);

/// Whether the key has a visible effect there.
bool works_in(PreviewFront front, PreviewKey key);

/// The text at the edge of a preview while its help is closed.
inline constexpr std::string_view help_hint = "h: help";

/// One line for each key that works there: its name, spaces, and what it does.
std::vector<std::string> preview_key_help(PreviewFront front);

/// The same, and in a window a last line of that kind about its mouse.
std::vector<std::string> preview_help(PreviewFront front);

}
