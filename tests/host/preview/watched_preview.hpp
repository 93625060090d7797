#pragma once

#include "host/preview/viewer/viewer.hpp"
#include "tests/host/preview/opened_scenes.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

namespace kfast::test {

namespace fs = std::filesystem;

using Seconds = Viewer::Seconds;

/// 10 frames a second and 10 frames; a clip, an input and two objects.
inline constexpr const char* moving = R"(kfast 1
canvas 16 16 fps=10 frames=10
input gaze min=-1 max=1
clip blink from=4 to=8
object lamp fill="#ff0000" {
    key 0 { rect 0 0 4 4 }
    key 5 { rect 12 12 4 4 }
}
object shade fill="#00ff00" {
    key 0 { rect 8 0 4 4 }
    track x input=gaze { at -1 0; at 1 4 }
}
)";

inline void write(const fs::path& file, const std::string& text) { std::ofstream{file} << text; }

inline std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    return text.replace(text.find(what), what.size(), with);
}

/// A viewer of a file in a folder of its own, and its clock.
struct Preview {
    explicit Preview(const std::string& text = moving) { write(folder / "lamp.kfast", text); }

    void press(std::initializer_list<PreviewKey> keys)
    {
        for (const PreviewKey key : keys)
            viewer.press(key, now);
    }
    void finish_work()
    {
        while (viewer.is_working())
            viewer.attend(now);
    }
    /// Long enough for what was written to be noticed.
    void wait(double seconds = 1)
    {
        for (const Seconds end = now + Seconds{seconds}; now < end;) {
            now += Seconds{0.1};
            viewer.attend(now);
        }
    }
    /// As editors do.
    void replace(const std::string& text)
    {
        write(folder / "lamp.kfast~", text);
        fs::rename(folder / "lamp.kfast~", folder / "lamp.kfast");
    }

    TemporaryFolder folder;
    bool is_written = (write(folder / "lamp.kfast", moving), true);
    Seconds now{1000};
    Viewer viewer{open_scene, open_scene(folder / "lamp.kfast"), now};
};

inline bool says(const std::vector<std::string>& lines, const std::string& word)
{
    return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(word) != line.npos; });
}

}
