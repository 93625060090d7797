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
    zoom_in,
    zoom_out,
    next_item,
    previous_item,
    screenshot,
    gif,
    help,
    quit
};

/// `name` as in a list of keys: space n p r a h q escape right left up down v l c b
/// i + - t o k m d f e y z x tab shift-tab s g.
std::optional<PreviewKey> preview_key(std::string_view name);

/// One line per key, for the help of the window and of the command.
std::vector<std::string> preview_key_help();

}
