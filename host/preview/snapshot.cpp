#include "host/preview/snapshot.hpp"

#include "host/preview/headless.hpp"
#include "host/preview/painter/raster_painter.hpp"
#include "host/preview/window/preview_screen.hpp"

#include <chrono>
#include <thread>

namespace kfast {
namespace {

void wait_for_report(Viewer& viewer)
{
    using namespace std::chrono_literals;
    while (viewer.view().fit_report && !viewer.fit_report())
        std::this_thread::sleep_for(10ms);
}

}

Picture snapshot(Viewer& viewer, std::span<const ScriptStep> script, Size window, std::ostream& out)
{
    RasterPainter painter;
    PreviewScreen screen;
    const auto draw = [&] {
        painter.begin(window);
        screen.draw(painter, viewer, Viewer::Seconds{0});
    };
    draw();
    play_script(viewer, script, out,
                [&](PreviewKey key, Viewer::Seconds now) { screen.press(key, viewer, now); });
    wait_for_report(viewer);
    draw();
    return painter.drawn();
}

}
