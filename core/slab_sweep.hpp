#pragma once

#include "core/coverage_row.hpp"
#include "core/sweep_line.hpp"

#include <cstdint>

namespace kfast {

/// Fills a row in which chains begin, end, bend or cross each other as they please. It is cut into slabs, at
/// every sub-row where one of these happens; within a slab the edges keep their order.
class SlabSweep {
public:
    /// `line` stands at sub-row `top`, where the row begins.
    SlabSweep(SweepLine& line, std::int32_t top, CoverageRow& coverage)
        : line_{line}, coverage_{coverage}, y_{top}, bottom_{top + subrows}
    {
    }

    /// Adds what the layer encloses in the row, and moves the line below it.
    void run();

private:
    std::int32_t next_event() const;
    Fixed x_at_slab_end(const Chain& chain) const;
    bool is_left_of(const Chain& a, const Chain& b) const;
    void sort();
    std::int32_t first_crossing() const;
    std::int32_t crossing(std::int64_t before, std::int64_t after) const;
    void fill();

    SweepLine& line_;
    CoverageRow& coverage_;
    std::int32_t y_; ///< where the slab begins
    std::int32_t bottom_;
    std::int32_t slab_end_ = 0;
};

}
