#include "host/preview/controls/preview_key.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

struct Named {
    std::string_view name;
    PreviewKey key;
    std::string_view help;
    std::string_view in_terminal = help; ///< empty: does nothing there
};

constexpr std::string_view nothing;

constexpr std::array names{
    Named{"space", PreviewKey::play_pause, "play, pause; after 'a' the next frame"},
    Named{"n", PreviewKey::next_key, "next key frame"},
    Named{"p", PreviewKey::previous_key, "previous key frame"},
    Named{"right", PreviewKey::next_frame, "next frame"},
    Named{"left", PreviewKey::previous_frame, "previous frame"},
    Named{"a", PreviewKey::all_frames, "generate all frames, to step through with space"},
    Named{"up", PreviewKey::faster, "faster"},
    Named{"down", PreviewKey::slower, "slower"},
    Named{"v", PreviewKey::reverse, "backwards, forwards"},
    Named{"l", PreviewKey::loop, "again and again, once, as the scene says"},
    Named{"c", PreviewKey::next_clip, "next clip"},
    Named{"b", PreviewKey::previous_clip, "clip before"},
    Named{"r", PreviewKey::read_file, "read a file", "read the file afresh"},
    Named{"i", PreviewKey::next_input, "next input"},
    Named{"+", PreviewKey::more_input, "more of the input"},
    Named{"-", PreviewKey::less_input, "less of the input"},
    Named{"tab", PreviewKey::next_item, "select the next object"},
    Named{"shift-tab", PreviewKey::previous_item, "select the object before"},
    Named{"enter", PreviewKey::edit, "edit the text where the object stands"},
    Named{"o", PreviewKey::onion_skin, "onion skin: the key frames before and after"},
    Named{"k", PreviewKey::bones, "skeletons and backbones", nothing},
    Named{"m", PreviewKey::numbers, "numbers of points and strokes", nothing},
    Named{"d", PreviewKey::changed_areas, "areas that differ from the picture before", nothing},
    Named{"f", PreviewKey::panel_frame, "the panel's frame", nothing},
    Named{"e", PreviewKey::fit_report, "does it fit a board, and how fast is it?", nothing},
    Named{"y", PreviewKey::time_line, "time line", nothing},
    Named{"u", PreviewKey::quantities, "unfold the object's keys by quantity, or all", nothing},
    Named{"w", PreviewKey::board_speed, "play as slowly as the board would"},
    Named{"z", PreviewKey::zoom_in, "larger pixels", nothing},
    Named{"x", PreviewKey::zoom_out, "smaller pixels", nothing},
    Named{"t", PreviewKey::travel, "travel of a beam, and its points"},
    Named{"s", PreviewKey::screenshot, "write this picture as PNG"},
    Named{"g", PreviewKey::gif, "write all frames as GIF"},
    Named{"h", PreviewKey::help, "this help, as does ?"},
    Named{"q", PreviewKey::quit, "quit"},
    Named{"escape", PreviewKey::leave, "close this help, or quit"},
};

constexpr std::string_view also_help = "?"; // what many programs take for it
constexpr std::size_t name_width = 11;

std::string line_of(std::string_view name, std::string_view help)
{
    std::string line{name};
    line.resize(name_width, ' ');
    return line.append(help);
}

std::string_view help_of(const Named& row, PreviewFront front)
{
    return front == PreviewFront::terminal ? row.in_terminal : row.help;
}

}

std::optional<PreviewKey> preview_key(std::string_view name)
{
    if (name == also_help)
        return PreviewKey::help;
    const auto found = std::ranges::find(names, name, &Named::name);
    return found == names.end() ? std::nullopt : std::optional{found->key};
}

bool works_in(PreviewFront front, PreviewKey key)
{
    const auto* const row = std::ranges::find(names, key, &Named::key);
    return row != names.end() && !help_of(*row, front).empty();
}

std::vector<std::string> preview_key_help(PreviewFront front)
{
    std::vector<std::string> lines;
    for (const Named& row : names)
        if (works_in(front, row.key))
            lines.push_back(line_of(row.name, help_of(row, front)));
    return lines;
}

std::vector<std::string> preview_help(PreviewFront front)
{
    std::vector<std::string> lines = preview_key_help(front);
    if (front == PreviewFront::window)
        lines.push_back(line_of("mouse", "click an object, drag the time line, wheel, drop a file"));
    return lines;
}

}
