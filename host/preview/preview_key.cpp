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
    Named{"space", PreviewKey::play_pause, "play, pause"},
    Named{"n", PreviewKey::next_key, "next key frame"},
    Named{"p", PreviewKey::previous_key, "previous key frame"},
    Named{"right", PreviewKey::next_frame, "next frame"},
    Named{"left", PreviewKey::previous_frame, "previous frame"},
    Named{"up", PreviewKey::faster, "faster"},
    Named{"down", PreviewKey::slower, "slower"},
    Named{"r", PreviewKey::reverse, "backwards, forwards"},
    Named{"c", PreviewKey::next_clip, "next clip"},
    Named{"b", PreviewKey::previous_clip, "clip before"},
    Named{"i", PreviewKey::next_input, "next input"},
    Named{"+", PreviewKey::more_input, "more of the input"},
    Named{"-", PreviewKey::less_input, "less of the input"},
    Named{"t", PreviewKey::travel, "travel of a beam, and its points"},
    Named{"h", PreviewKey::help, "this help, in the window"},
    Named{"q", PreviewKey::quit, "quit"},
    Named{"escape", PreviewKey::quit, "quit"},
};

constexpr std::size_t name_width = 8;

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
