#pragma once

#include "host/preview/window/preview_screen.hpp"
#include "tests/host/preview/opened_scenes.hpp"
#include "tests/host/preview/recording_painter.hpp"
#include "tests/temporary_folder.hpp"

#include <fstream>
#include <initializer_list>
#include <string>
#include <utility>

namespace kfast::test {

/// Two objects beside each other; as many frames as the time line of a window has room for.
inline constexpr const char* two_halves = R"(kfast 1
canvas 20 20 fps=10 frames=100
input gaze min=-1 max=1
clip blink from=40 to=80
event 10 step
object left fill="#ff0000" {
    key 0 { rect 0 0 10 20 }
    key 50 { rect 0 0 9 20 }
}
object right fill="#00ff00" {
    key 0 { rect 10 0 10 20 }
    track opacity input=gaze { at -1 1; at 1 0.5 }
}
)";

/// A preview in a window that somebody uses with a mouse.
struct Window {
    using Kind = PointerEvent::Kind;

    Window()
    {
        viewer.scrub(Time{0});
        draw();
    }

    const RecordingPainter& draw(Size size = {900, 600})
    {
        painter = RecordingPainter{size};
        screen.draw(painter, viewer, now);
        return painter;
    }
    void touch(Kind kind, int x, int y, int wheel = 0) { screen.touch({kind, x, y, wheel}, viewer, now); }
    void press(PreviewKey key) { screen.press(key, viewer, now); }
    void drag(std::initializer_list<std::pair<int, int>> way)
    {
        const auto [first_x, first_y] = *way.begin();
        touch(Kind::press, first_x, first_y);
        for (const auto& [x, y] : way)
            touch(Kind::move, x, y);
        const auto [last_x, last_y] = *(way.end() - 1);
        touch(Kind::release, last_x, last_y);
    }
    void click(int x, int y) { drag({{x, y}}); }
    bool has_text(const char* text) const { return painter.find(text) != nullptr; }
    TimeLine time_line() const
    {
        const int height = TimeLine::wanted_height(viewer.time_table());
        return {viewer.time_table(), {0, 576 - height, 900, height}};
    }
    int frame() const { return viewer.playback().frame(); }
    std::string selected() const { return std::string{viewer.selected_name()}; }

    TemporaryFolder folder;
    bool is_written = (std::ofstream{folder / "halves.kfast"} << two_halves, true);
    Viewer::Seconds now{1000};
    Viewer viewer{open_scene, open_scene(folder / "halves.kfast"), now};
    PreviewScreen screen;
    RecordingPainter painter{{1, 1}};
};

}
