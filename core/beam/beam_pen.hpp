#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_profile.hpp"
#include "core/colour.hpp"
#include "core/point.hpp"
#include "core/segment.hpp"
#include "core/sight.hpp"

#include <cstdint>

namespace kfast {

/// Turns the live strokes of one object (LiveStrokes::trace()) into lines in the field.
class BeamPen {
public:
    /// `resolution` is that of the profile: so many pixels has a side of the panel that stands for the field.
    BeamPen(BeamLines& lines, const Sight& sight, int resolution, Colour colour, std::uint32_t item)
        : lines_{lines}, sight_{sight}, units_{field_side / resolution}, colour_{colour}, item_{item}
    {
    }

    void begin(Point from);
    void add(const Segment& segment);
    void end(Point hub, bool is_closed);

private:
    void line_to(Point seen);

    BeamLines& lines_;
    Sight sight_;
    std::int32_t units_; ///< of the field in a pixel
    Colour colour_;
    std::uint32_t item_;
};

}
