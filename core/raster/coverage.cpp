#include "core/raster/coverage.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/raster/outline/grid.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace kfast::raster {
namespace {

/// An edge that is `width` wide: how much of its row is to the left of a point on it.
class Ramp {
public:
    explicit Ramp(std::uint32_t width)
    {
        for (; width > 256; ++shift_)
            width = (width + 1) >> 1;
        inverse_ = reciprocals[width];
    }

    /// The area to the right of the edge in a pixel that it enters `length` before its right border.
    std::int32_t triangle(std::uint32_t length) const
    {
        return static_cast<std::int32_t>((length * length * inverse_) >> (shift_ - 1));
    }
    /// The same for pixels that it crosses from side to side, the first of them `length` after its beginning:
    /// calls put(area) for each of that many pixels.
    template <class Put>
    void slices(std::uint32_t length, int count, Put put) const
    {
        std::uint32_t area = (length + grid / 2) * inverse_;
        for (; count > 0; --count, area += grid * inverse_)
            put(static_cast<std::int32_t>(area >> (shift_ - 8)));
    }
    /// `height` times the part of the width that is `length`.
    std::int32_t part(std::int32_t height, std::uint32_t length) const
    {
        return height * static_cast<std::int32_t>((length * inverse_) >> (shift_ - 10)) >> 10;
    }

private:
    std::uint32_t inverse_;
    unsigned shift_ = 16;
};

[[gnu::noinline]] void cover_wide(const RowEdge& edge, int columns, CoverageRun& run)
{
    const int first = edge.pixel();
    const int behind = ceil_pixel(edge.high);
    run.begin = std::clamp(first, 0, columns);
    run.end = std::clamp(behind, 0, columns);
    count_op(Op::flat_pixel, static_cast<std::uint32_t>(run.end - run.begin));
    const Ramp ramp{static_cast<std::uint32_t>(edge.high - edge.low)};
    std::uint16_t* out = run.pixels.data();
    const auto put = [&out](std::int32_t coverage) { *out++ = static_cast<std::uint16_t>(coverage); };
    int pixel = run.begin;
    if (pixel == first && pixel != run.end)
        put(ramp.triangle(static_cast<std::uint32_t>(++pixel * grid - edge.low)));
    const int whole_end = std::min(run.end, behind - 1);
    ramp.slices(static_cast<std::uint32_t>(pixel * grid - edge.low), whole_end - pixel,
                [put](std::int32_t coverage) { put(std::min(coverage, full_coverage)); });
    if (run.end == behind && behind > pixel)
        put(full_coverage - ramp.triangle(static_cast<std::uint32_t>(edge.high - (behind - 1) * grid)));
}

}

/// Nearly all edges are short enough for the table of reciprocals, and within the tile. Ramp gives the
/// same.
void cover_flat(const RowEdge& edge, int columns, CoverageRun& run)
{
    const int first = edge.pixel();
    const int behind = ceil_pixel(edge.high);
    const auto width = static_cast<std::uint32_t>(edge.high - edge.low);
    if (first < 0 || behind > columns || width >= reciprocals.size())
        return cover_wide(edge, columns, run);
    count_op(Op::flat_pixel, static_cast<std::uint32_t>(behind - first));
    run.begin = first;
    run.end = behind;
    const std::uint32_t inverse = reciprocals[width];
    std::uint32_t length = grid - (static_cast<std::uint32_t>(edge.low) & (grid - 1)); // in the first pixel
    std::uint16_t* out = run.pixels.data();
    *out++ = static_cast<std::uint16_t>(length * length * inverse >> 15);
    for (; width - length > grid; length += grid)
        *out++ = static_cast<std::uint16_t>(
            std::min<std::uint32_t>((length + grid / 2) * inverse >> 8, full_coverage));
    length = width - length;
    *out = static_cast<std::uint16_t>(full_coverage - (length * length * inverse >> 15));
}

/// What is to the left of the tile counts from its first pixel on.
void CoverageSums::put(int column, std::int32_t area, int columns)
{
    if (column < columns)
        sums_[static_cast<std::size_t>(std::max(column, 0))] += area;
}

void CoverageSums::add(const RowEdge& edge, std::int32_t direction, int columns)
{
    count_op(Op::sum_part);
    constexpr std::int32_t unit = full / full_coverage;
    CoverageRun run;
    cover(edge, columns, run);
    std::int32_t before = 0;
    for (int pixel = run.begin; pixel != run.end; ++pixel) {
        const std::int32_t coverage = run.pixels[static_cast<std::size_t>(pixel - run.begin)];
        put(pixel, (coverage - before) * direction * unit, columns);
        before = coverage;
    }
    put(std::max(ceil_pixel(edge.high), edge.pixel() + 1), (full_coverage - before) * direction * unit,
        columns);
}

/// The inside is rounded, as in sums of all edges of a row.
void CoverageSums::take(bool runs_down, bool is_inside_left, CoverageRun& run)
{
    std::int32_t sum = 0;
    std::uint16_t* out = run.pixels.data();
    for (int column = run.begin; column != run.end; ++column) {
        sum += std::exchange(sums_[static_cast<std::size_t>(column)], 0);
        const std::int32_t right = runs_down ? sum : -sum;
        *out++ = static_cast<std::uint16_t>(is_inside_left ? full_coverage - coverage(std::abs(full - right))
                                                           : coverage(std::abs(right)));
    }
    sums_[static_cast<std::size_t>(run.end)] = 0;
}

void CoverageSums::add_part(std::int32_t a, std::int32_t b, std::int32_t height, int columns)
{
    count_op(Op::sum_part);
    const int column = floor_pixel(a);
    if (column == floor_pixel(b))
        put_part(column, height, (a & (grid - 1)) + (b & (grid - 1)), columns);
    else if (a < b)
        add_wide_part(a, b, height, columns);
    else
        add_wide_part(b, a, height, columns);
}

/// Adds an edge within a pixel; `ends` is how far its ends are to the right of the pixel's left border.
void CoverageSums::put_part(int column, std::int32_t height, std::int32_t ends, int columns)
{
    static_assert(part_height * whole == full);
    if (column >= columns)
        return;
    const std::int32_t right = height * ends;
    if (column < 0) {
        sums_[0] += height * whole; // also what counts from column 0 on
        return;
    }
    sums_[static_cast<std::size_t>(column)] += height * whole - right;
    if (column + 1 < columns)
        sums_[static_cast<std::size_t>(column) + 1] += right;
}

void CoverageSums::add_wide_part(std::int32_t a, std::int32_t b, std::int32_t height, int columns)
{
    int column = floor_pixel(a);
    const int last = floor_pixel(b);
    if (column >= columns)
        return;
    if (last < 0)
        return put(0, height * whole, columns);
    const Ramp ramp{static_cast<std::uint32_t>(b - a)};
    std::int32_t done = 0;
    std::int32_t from = a & (grid - 1);
    if (column < 0) {
        column = 0;
        from = 0;
        done = ramp.part(height, static_cast<std::uint32_t>(-a));
        put(0, done * whole, columns);
    }
    for (; column < last && column < columns; ++column) {
        const std::int32_t part = ramp.part(height, static_cast<std::uint32_t>((column + 1) * grid - a));
        put_part(column, part - done, from + grid, columns);
        done = part;
        from = 0;
    }
    put_part(last, height - done, b & (grid - 1), columns);
}

}
