#pragma once

#include "host/beam/ilda_reader.hpp"

#include <cstddef>
#include <set>

namespace kfast {

/// What an ILDA file amounts to. Lengths are in units of the field.
struct IldaFacts {
    std::set<IldaFormat> formats; ///< of frames
    std::size_t points = 0;
    std::size_t lit_points = 0;
    std::size_t max_points = 0;  ///< in a frame
    FieldPoint min;              ///< of all points: left and bottom,
    FieldPoint max;              ///< right and top
    double longest_lit_step = 0; ///< to a lit point, from the one before it in the frame
    double longest_blanked_step = 0;
};

/// `contents` has at least one frame.
IldaFacts ilda_facts(const IldaContents& contents);

}
