#pragma once

#include "core/fill_rule.hpp"
#include "core/raster/coverage.hpp"
#include "core/raster/row_chain.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// Adds the areas of a chain of a row.
void add_chain(const RowChain& chain, int columns, CoverageSums& sums);

/// Chains of a group that add_group() takes, at most. Larger ones are added line by line.
inline constexpr std::size_t max_group = 16;

/// Adds the areas of chains of a layer that share pixels in a row, and of no others; `winding` is that to the
/// left of them. Their order changes. Returns that to the right of them.
///
/// Sums of areas tell the coverage as long as windings go no further than from 0 to 1, or never to 0. Where
/// they do, as where two outlines overlap within a pixel, only edges between inside and outside are added:
///
///     windings     0 | 1 | 2 | 1 | 0
///     added          +           -       if no edges cross in the row; else line by line, 8 in a row
std::int32_t add_group(std::span<RowChain> chains, FillRule rule, std::int32_t winding, int columns,
                       CoverageSums& sums);

/// Where chains cross a line through a row, from left to right: a part of it at a time, for they are any
/// number.
///
///     begin_part() -> add() for all chains -> walk() or add_inside(), until is_complete()
class Line {
public:
    static constexpr int count_in_row = 8;

    /// The n-th of a row.
    explicit Line(int number) : y_{(2 * number + 1) * grid / (2 * count_in_row)} {}

    /// To the right of the parts before.
    void begin_part();
    /// In the same order for each part.
    void add(const RowChain& chain);
    /// This part is the last one.
    bool is_complete() const { return !has_more_; }
    /// Notes the windings in the part.
    template <class Note>
    void walk(std::int32_t winding, Note note) const
    {
        for (std::size_t i = 0; i != count_; ++i)
            note(winding += step(i));
    }
    /// Adds a share of the row: what lies inside on the part; `winding` is that to the left of it. Returns
    /// that to the right of it.
    std::int32_t add_inside(FillRule rule, std::int32_t winding, int columns, CoverageSums& sums) const;

private:
    static constexpr std::size_t max_count = max_group;

    /// They are in the order of their places, then in that of add().
    struct Crossing {
        std::int32_t x2; ///< 2 x, or 2 x + 1 if the outline runs up there
        std::int32_t number;
    };

    int step(std::size_t place) const { return (crossings_[place].x2 & 1) == 0 ? 1 : -1; }

    std::int32_t y_;
    std::int32_t added_ = 0; ///< crossings, in this part and others
    std::size_t count_ = 0;
    bool has_more_ = false;
    bool is_first_ = true;
    Crossing before_{}; ///< the last one of the parts before
    std::array<Crossing, max_count> crossings_;
};

/// From a column on, only whether it is inside counts, and no more how often outlines go around it; or the
/// other way round behind it.
void begin_inside(int column, FillRule rule, std::int32_t winding, int columns, CoverageSums& sums);
void end_inside(int column, FillRule rule, std::int32_t winding, int columns, CoverageSums& sums);

}
