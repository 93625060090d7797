#pragma once

#include "core/math/point.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace kfast {

/// A point on a panel, in its pixels; y points down, and 0.5 is the middle of the first pixel.
struct PanelSpot {
    double x = 0;
    double y = 0;
};

/// What a mark represents: the colour is chosen by that.
enum class MarkKind : std::uint8_t {
    bone,
    backbone,
    outline,      ///< of an object that is selected or numbered, and of a backbone
    control,      ///< from a point to its control point
    point,        ///< of a stroke, with its number
    stroke,       ///< the number of a stroke
    changed_area, ///< what a board would send
};

/// What is drawn over the picture of a panel to explain it, in this order.
struct Overlay {
    struct Area {
        Rect place;
        MarkKind kind;
    };
    struct Line {
        PanelSpot from;
        PanelSpot to;
        MarkKind kind;
    };
    struct Dot {
        PanelSpot at;
        MarkKind kind;
    };
    struct Label {
        PanelSpot at;
        std::string text;
        MarkKind kind;
    };
    std::vector<Area> areas;
    std::vector<Line> lines;
    std::vector<Dot> dots;
    std::vector<Label> labels;
    std::string facts; ///< of what is shown, on one line: "2 areas, 1312 bytes, 4 % of the panel"; or empty
};

}
