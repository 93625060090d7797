#pragma once

#include "core/point.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace kfast {

/// Rows are divided into 1024 sub-rows; corners lie on them.
inline constexpr std::int32_t subrows = 1024;

/// A corner of an outline made of straight lines.
struct Corner {
    Fixed x;
    std::int32_t y = 0; ///< in sub-rows

    friend constexpr bool operator==(Corner, Corner) = default;
};

/// A stretch of an outline along which y does not turn back, and where a sweep from above stands in it.
struct Chain {
    static constexpr std::uint16_t none = 0xFFFF;

    std::uint16_t first = 0; ///< its uppermost corner
    std::uint16_t edges : 15 = 0;
    std::uint16_t runs_up : 1 = 0; ///< the outline runs from the lower end to the upper one
    std::uint16_t passed = 0;      ///< edges that the sweep has left behind
    std::uint16_t next = none;     ///< to the right of it, under the sweep
    Fixed x;                       ///< of the current edge, at the upper border of the row
    std::int32_t slope = 0;        ///< of the current edge if it is a row high: 1/65536 px in a row

    std::int32_t winding() const { return runs_up != 0 ? -1 : 1; }
};

static_assert(sizeof(Corner) == 8 && sizeof(Chain) == 16);

/// Outlines that are painted together: what lies between two marks of an OutlineStore.
struct OutlineRange {
    std::uint16_t first_corner = 0;
    std::uint16_t end_corner = 0;
    std::uint16_t first_chain = 0;
    std::uint16_t end_chain = 0;

    bool empty() const { return first_chain == end_chain; }
};

/// The outlines of one picture: the corners of closed contours, and the chains that these fall into, in
/// memory that the caller lends. Corners fill it from the front, chains from the back.
class OutlineStore {
public:
    static constexpr std::uint16_t most_corners = 0xFFFE;
    static constexpr int every_row = std::numeric_limits<std::int32_t>::max() / subrows;

    OutlineStore() = default;
    /// `storage` is aligned to 4 bytes, and its size a multiple of 4. Chains outside of 0 … `rows` are left
    /// out; none is if `rows` is every_row.
    OutlineStore(std::span<std::byte> storage, int rows);

    void clear();

    /// A contour is told from both of its ends at once: its corners in order are those that were added, then
    /// those that were added behind, the last of these first. So both sides of a line can be drawn as it is
    /// followed. Nothing else is added before close().
    void add(Corner corner);
    void add_behind(Corner corner);
    /// Joins the last corner to the first.
    void close();

    /// To tell a range: what was closed since the marks were equal to the counts.
    OutlineRange range_from(const OutlineRange& mark) const;
    OutlineRange mark() const { return {corner_count_, corner_count_, chain_count_, chain_count_}; }
    /// Puts the chains of a range in the order of their upper ends.
    void sort(const OutlineRange& range);
    /// Whether a range has the same corners, and so the same chains, as one of another store.
    bool is_equal(const OutlineRange& range, const OutlineStore& other, const OutlineRange& others) const;
    /// Takes over a range of another store.
    OutlineRange copy(const OutlineStore& from, const OutlineRange& range);

    Chain& chain(std::uint16_t number) { return end_[-1 - number]; }
    const Chain& chain(std::uint16_t number) const { return end_[-1 - number]; }
    const Corner& corner(std::int32_t number) const { return corners_[number]; }

    /// Something found no room: the picture is not complete.
    bool is_full() const { return is_full_; }
    std::size_t used_bytes() const { return corner_count_ * sizeof(Corner) + chain_count_ * sizeof(Chain); }

private:
    bool find_room(std::size_t corners, std::size_t chains);
    Corner* behind() { return reinterpret_cast<Corner*>(end_ - chain_count_) - behind_count_; }
    bool join_sides();
    void find_chains(std::int32_t first, std::int32_t last);
    void add_chain(std::int32_t first, std::int32_t last);
    bool is_outside(Corner upper, Corner lower) const;

    Corner* corners_ = nullptr;
    Chain* end_ = nullptr;
    std::size_t size_ = 0;
    std::int32_t bottom_ = 0; ///< sub-row below the last one
    std::uint16_t corner_count_ = 0;
    std::uint16_t chain_count_ = 0;
    std::uint16_t contour_ = 0; ///< its first corner
    std::uint16_t behind_count_ = 0;
    bool is_full_ = false;
};

}
