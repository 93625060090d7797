#pragma once

#include "core/crossings.hpp"
#include "core/sweep_line.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace kfast {

/// What a row cuts out of a chain. All x are in 1/65536 px.
struct RowPart {
    Chain* chain;          ///< as it stands at the top
    std::uint16_t number;  ///< of the chain
    std::uint16_t corners; ///< that it passes within the row or at its lower border
    bool is_straight;      ///< it runs through the row, with a slight bend at most
    bool is_over;          ///< nothing of the chain is left below the row
    std::int32_t top;      ///< its sub-rows; only if it is not straight
    std::int32_t bottom;
    std::int32_t begin; ///< x at its top
    std::int32_t end;   ///< x at its bottom
    std::int32_t left;  ///< the least x within it
    std::int32_t right;
    std::int32_t next_x;     ///< of the edge below, if it passes corners and is not over
    std::int32_t next_slope; ///< likewise

    /// Straight on from its beginning.
    void end_at(std::int32_t x)
    {
        end = x;
        left = std::min(begin, x);
        right = std::max(begin, x);
    }
};

static_assert(std::is_trivially_default_constructible_v<RowPart>); // RowParts are made for every row

/// The parts that a row cuts out of the chains of a layer, from left to right. No chain moves that is under
/// way.
class RowParts {
public:
    static constexpr std::size_t most = Crossings::most;

    /// The row begins at sub-row `top`, where `line` stands.
    RowParts(SweepLine& line, std::int32_t top) : line_{line}, top_{top}, bottom_{top + subrows} {}

    /// False if there are too many.
    bool find();

    /// Whether all parts run through the row.
    bool run_through() const { return run_through_; }
    /// Whether each part lies wholly to the left of the next and has the same winding number to its left all
    /// along: what does not run through the row comes in pairs that enclose something.
    bool stand_apart() const
    {
        return (came_apart_ && run_through_) || (lie_apart() && (run_through_ || come_in_pairs()));
    }

    std::size_t size() const { return count_; }
    const RowPart& operator[](std::size_t number) const { return *order_[number]; }

    RowParts(const RowParts&) = delete;
    RowParts& operator=(const RowParts&) = delete;

private:
    void add_under_way(std::uint16_t number);
    void add_beginning(std::uint16_t number);
    RowPart& begin_part(std::uint16_t number, Chain& chain);
    void bend(RowPart& part, const ChainEdge& edge);
    void put_in_order(RowPart& part);
    void put_between(RowPart& part);
    void follow(RowPart& part, ChainEdge edge) const;
    bool lie_apart() const;
    bool come_in_pairs() const;
    bool runs_through(const RowPart& part) const
    {
        return part.is_straight || (part.top == top_ && part.bottom == bottom_);
    }

    SweepLine& line_;
    std::int32_t top_;
    std::int32_t bottom_;
    std::size_t count_ = 0;
    bool run_through_ = true;
    bool came_apart_ = true; ///< each to the right of the one before
    std::array<RowPart, most> parts_;
    std::array<RowPart*, most> order_;
};

}
