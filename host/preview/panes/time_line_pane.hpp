#pragma once

#include "host/preview/painter/painter.hpp"
#include "host/preview/panes/time_line.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace kfast {

/// What a time line shows besides its table.
struct TimeLineState {
    Time now;
    std::uint32_t frame_rate = 30000;         ///< frames in 1000 seconds
    std::optional<std::size_t> selected = {}; ///< a TimeRow::item
    std::string clip = {};                    ///< the one that plays; empty if it is the whole scene
};

/// Frames between two numbers of the ruler: 1, 2, 5, 10, 20, 50 … so that each has `room` pixels.
int ruler_step(double pixels_per_frame, double room);

void draw_time_line(Painter& painter, const TimeLine& line, const TimeLineState& state);

}
