#pragma once

#include "core/math/projection.hpp"

#include <string>

namespace kfast {

/// Writes live strokes as the data of an SVG path, in pixels of the panel. PosedStrokes::trace() tells what
/// begin(), add() and end() are.
class SvgPath {
public:
    enum class Use { fill, stroke };

    /// Curves stay curves, unless they are projected: then they become lines, for the projection of a curve
    /// is none.
    SvgPath(const Projection* projection, Use use)
        : is_projected_{projection != nullptr}, sight_{projection, 0}, use_{use}
    {
    }

    void begin(Point from);
    void add(const Segment& segment);
    void end(Point hub, bool is_closed);

    const std::string& data() const { return data_; }

private:
    void write(char command, Point at);
    void write(Point at);

    bool is_projected_;
    ViewProjection sight_;
    Use use_;
    Point last_; ///< as the next two, before it is projected
    Point start_;
    std::string data_;
};

}
