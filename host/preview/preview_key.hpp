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
    help,
    quit
};

/// `name` as in a list of keys: space n p right left up down r c b i + - t h q escape.
std::optional<PreviewKey> preview_key(std::string_view name);

/// One line per key, for the help of the window and of the command.
std::vector<std::string> preview_key_help();

}
