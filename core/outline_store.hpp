#pragma once

#include "core/point.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Rows are divided into 1024 sub-rows; corners lie on them.
inline constexpr std::int32_t subrows = 1024;

/// A corner of an outline made of straight lines.
struct Corner {
    Fixed x;
    std::int32_t y = 0; ///< in sub-rows
};

/// A stretch of an outline along which y does not turn back, and where a sweep from above stands in it.
struct Chain {
    static constexpr std::uint16_t none = 0xFFFF;

    std::uint16_t first = 0; ///< its uppermost corner
    std::uint16_t edges : 15 = 0;
    std::uint16_t runs_up : 1 = 0; ///< the outline runs from the lower end to the upper one
    std::uint16_t passed = 0;      ///< edges that the sweep has left behind
    std::uint16_t next = none;     ///< to the right of it, under the sweep
    Fixed x;                       ///< where the current edge crosses the upper border of the row
    std::int32_t slope = 0;        ///< of the current edge: 1/65536 px in a row

    std::int32_t winding() const { return runs_up != 0 ? -1 : 1; }
};

static_assert(sizeof(Chain) == 16);

/// The outlines of one picture: the corners of closed contours, and the chains that these fall into, in
/// memory that the caller lends. Corners fill it from the front, chains from the back.
class OutlineStore {
public:
    /// `storage` is aligned to 4 bytes.
    explicit OutlineStore(std::span<std::byte> storage);

    void clear();

    /// A contour is told from both of its ends at once: its corners in order are those that were added, then
    /// those that were added behind, the last of these first. So both sides of a line can be drawn as it is
    /// followed. Nothing else is added before close().
    void add(Point corner);
    void add_behind(Point corner);
    /// Joins the last corner to the first.
    void close();

    /// Something found no room: the picture is not complete.
    bool is_full() const { return is_full_; }
    std::size_t used_bytes() const;

    std::uint16_t corner_count() const { return corner_count_; }
    std::uint16_t chain_count() const { return chain_count_; }

private:
    bool is_full_ = false;
    std::uint16_t corner_count_ = 0;
    std::uint16_t chain_count_ = 0;
};

}
