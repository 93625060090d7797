#include "host/compiler/write/path_writer.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/compiler/match/even_stroke.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace kfast {
namespace {

std::uint32_t stored_length(const MeasuredSegment& segment)
{
    return static_cast<std::uint32_t>(std::max(std::lround(segment.length * 16), 1L));
}

void report_length(const scene::Item& item, Diagnostics& diagnostics)
{
    diagnostics.error(item.place, "the path of this item is too long for the format",
                      "at most " + std::to_string(kfb::max_path / 16) +
                          " px; draw it shorter or with fewer turns");
}

}

void write_path(const scene::Item& item, DrawingPool& drawings, ByteWriter& bytes, Diagnostics& diagnostics)
{
    if (!item.path)
        return;
    const MeasuredStroke drawn = measured(item.path->stroke);
    // To make it even might take long.
    if (length_of(drawn) > kfb::max_path / 16.0)
        return report_length(item, diagnostics);
    const scene::Drawing drawing{{rounded(made_even(drawn))}};
    ByteWriter path;
    path.u8(item.path->turns ? 1 : 0);
    path.varint(static_cast<std::uint32_t>(drawings.offset_of(drawing)));
    std::uint64_t whole = 0;
    for (const MeasuredSegment& segment : measured(drawing.strokes.front())) {
        const std::uint32_t length = stored_length(segment);
        path.varint(length);
        whole += length;
    }
    bytes.block(path.bytes());
    if (whole > kfb::max_path || point_count(drawing) > kfb::max_drawing_points)
        report_length(item, diagnostics);
}

}
