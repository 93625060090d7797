#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/math/angle.hpp"
#include "core/math/point.hpp"
#include "core/scene/packed_drawing.hpp"

#include <cstdint>

namespace kfast {

/// What the pivot of an item follows; borrows the scene's bytes.
struct PathView {
    bool turns = false;        ///< the item turns as the path does
    bool is_known = false;     ///< no bit is set without a meaning
    std::uint32_t drawing = 0; ///< offset in the section of drawings: a single stroke
    ByteReader lengths;        ///< of its segments, varints in 1/16 px

    static PathView take(ByteReader& bytes);
};

/// A point on a path, and where the path leads there.
struct PathPlace {
    Point at;
    BinaryAngle direction;
};

/// At a share of the length in 1/2^24; below 0 and above 1 at the ends. The share within a segment is rounded
/// to 1/65536 (of one as long as 1/16 px is stored, to 1/256), the point to 3/65536 px.
PathPlace place_on(const PathView& path, PackedDrawing stroke, std::int32_t fraction);

}
