#include "host/preview/preview_key.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

struct Named {
    std::string_view name;
    PreviewKey key;
    std::string_view help;
};

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
    Named{"r", PreviewKey::read_file, "read a file"},
    Named{"i", PreviewKey::next_input, "next input"},
    Named{"+", PreviewKey::more_input, "more of the input"},
    Named{"-", PreviewKey::less_input, "less of the input"},
    Named{"tab", PreviewKey::next_item, "select the next object"},
    Named{"shift-tab", PreviewKey::previous_item, "select the object before"},
    Named{"o", PreviewKey::onion_skin, "onion skin: the key frames before and after"},
    Named{"k", PreviewKey::bones, "skeletons and backbones"},
    Named{"m", PreviewKey::numbers, "numbers of points and strokes"},
    Named{"d", PreviewKey::changed_areas, "areas that differ from the picture before"},
    Named{"f", PreviewKey::panel_frame, "the panel's frame"},
    Named{"e", PreviewKey::fit_report, "does it fit a board, and how fast is it?"},
    Named{"y", PreviewKey::time_line, "time line"},
    Named{"z", PreviewKey::zoom_in, "larger pixels"},
    Named{"x", PreviewKey::zoom_out, "smaller pixels"},
    Named{"t", PreviewKey::travel, "travel of a beam, and its points"},
    Named{"s", PreviewKey::screenshot, "write this picture as PNG"},
    Named{"g", PreviewKey::gif, "write all frames as GIF"},
    Named{"h", PreviewKey::help, "this help"},
    Named{"q", PreviewKey::quit, "quit"},
    Named{"escape", PreviewKey::quit, "quit"},
};

constexpr std::size_t name_width = 11;

}

std::optional<PreviewKey> preview_key(std::string_view name)
{
    const auto found = std::ranges::find(names, name, &Named::name);
    return found == names.end() ? std::nullopt : std::optional{found->key};
}

std::vector<std::string> preview_key_help()
{
    std::vector<std::string> lines;
    for (const Named& row : names) {
        std::string line{row.name};
        line.resize(name_width, ' ');
        lines.push_back(line.append(row.help));
    }
    return lines;
}

}
