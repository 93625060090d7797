#pragma once

#include "core/sweep_line.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast {

/// What a row cuts out of a chain.
struct RowPart {
    std::uint16_t number;  ///< of the chain
    std::uint16_t corners; ///< that it passes within the row or at its lower border
    bool is_straight;      ///< it runs through the row, with a slight bend at most
    bool is_over;          ///< nothing of the chain is left below the row
    std::int32_t top;      ///< its sub-rows
    std::int32_t bottom;
    Fixed begin; ///< x at its top
    Fixed end;   ///< x at its bottom
    Fixed left;  ///< the least x within it
    Fixed right;
    Chain* chain; ///< as it stands at the top
    Chain below;  ///< as it stands below the row, if it passes corners and is not over
};

/// The parts that a row cuts out of the chains of a layer, from left to right. Nothing is moved.
class RowParts {
public:
    static constexpr std::size_t most = 12;

    /// The row begins at sub-row `top`, where `line` stands.
    RowParts(const SweepLine& line, std::int32_t top) : line_{line}, top_{top}, bottom_{top + subrows} {}

    /// False if there are too many.
    bool find();

    /// Whether all parts run through the row.
    bool run_through() const { return run_through_; }
    /// Whether each part lies wholly to the left of the next and has the same winding number to its left all
    /// along: what does not run through the row comes in pairs that enclose something.
    bool stand_apart() const;

    std::size_t size() const { return count_; }
    const RowPart& operator[](std::size_t number) const { return *order_[number]; }

    RowParts(const RowParts&) = delete;
    RowParts& operator=(const RowParts&) = delete;

private:
    bool add(std::uint16_t number);
    void put_in_order(RowPart& part);
    void measure(RowPart& part) const;
    void follow(RowPart& part) const;
    bool bends_slightly(const RowPart& part) const;
    bool come_in_pairs() const;
    bool runs_through(const RowPart& part) const { return part.top == top_ && part.bottom == bottom_; }

    const SweepLine& line_;
    std::int32_t top_;
    std::int32_t bottom_;
    std::size_t count_ = 0;
    bool run_through_ = true;
    std::array<RowPart, most> parts_; // not initialized: made for every row
    std::array<RowPart*, most> order_;
};

}
