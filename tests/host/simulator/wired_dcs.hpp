#pragma once

#include "tests/host/simulator/wired_model.hpp"

#include <vector>

namespace kfast::test {

/// Wakes a controller that follows MIPI DCS, as far as all of them want it alike: 6 bytes, 240 ms.
inline WiredModel& start(WiredModel& wired, int access = 0x00, int format = 0x05)
{
    wired.wait(120).low({0x11}).wait(120);
    return wired.send(0x36, {access}).send(0x3A, {format}).low({0x29});
}

/// Opens a window for pixels.
inline WiredModel& window(WiredModel& wired, int left, int right, int top, int bottom)
{
    const auto range = [&wired](int command, int first, int last) {
        wired.send(command, {first >> 8, first & 255, last >> 8, last & 255});
    };
    range(0x2A, left, right);
    range(0x2B, top, bottom);
    return wired.low({0x2C});
}

inline WiredModel& colour(WiredModel& wired, int rgb565) { return wired.high({rgb565 >> 8, rgb565 & 255}); }

inline std::vector<int> glass(const WiredModel& wired)
{
    CHECK(wired.error() == "none");
    return pixels_of<PixelFormat::rgb565>(wired.model->picture());
}

/// A started ST7735 with a glass of 10 x 6 at (2, 1).
struct StartedSt7735 : WiredModel {
    StartedSt7735() : WiredModel{with_glass(Controller::st7735, {10, 6}, 2, 1)} { start(*this); }
};

}
