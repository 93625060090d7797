#include "core/outline_store.hpp"
#include "core/work.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

constexpr std::int32_t most_edges = 0x7FFF; ///< of one chain

}

OutlineStore::OutlineStore(std::span<std::byte> storage, int rows)
    : corners_{reinterpret_cast<Corner*>(storage.data())},
      end_{reinterpret_cast<Chain*>(storage.data() + storage.size())}, size_{storage.size()}, bottom_{rows *
                                                                                                      subrows}
{
}

void OutlineStore::clear()
{
    corner_count_ = 0;
    chain_count_ = 0;
    contour_ = 0;
    behind_count_ = 0;
    is_full_ = false;
}

bool OutlineStore::find_room(std::size_t corners, std::size_t chains)
{
    const std::size_t all = corner_count_ + behind_count_ + corners;
    is_full_ = is_full_ || all > most_corners || chain_count_ + chains >= Chain::none ||
               all * sizeof(Corner) + (chain_count_ + chains) * sizeof(Chain) > size_;
    return !is_full_;
}

void OutlineStore::add(Corner corner)
{
    did(Work::corner);
    if (find_room(1, 0))
        corners_[corner_count_++] = corner;
}

void OutlineStore::add_behind(Corner corner)
{
    did(Work::corner);
    if (!find_room(1, 0))
        return;
    ++behind_count_;
    *behind() = corner;
}

/// Chains lie in one piece: the first corner is repeated at the end.
void OutlineStore::close()
{
    if (join_sides() && corner_count_ != contour_) {
        add(corners_[contour_]);
        if (!is_full_)
            find_chains(contour_, corner_count_ - 1);
    }
    contour_ = corner_count_;
}

bool OutlineStore::join_sides()
{
    std::copy_n(behind(), behind_count_, corners_ + corner_count_);
    corner_count_ = static_cast<std::uint16_t>(corner_count_ + behind_count_);
    behind_count_ = 0;
    return !is_full_;
}

void OutlineStore::find_chains(std::int32_t first, std::int32_t last)
{
    std::int32_t begin = first; // of the chain
    std::int32_t end = first;   // of its last edge that is not level
    std::int32_t sense = 0;
    for (std::int32_t i = first; i < last; ++i) {
        const std::int32_t height = corners_[i + 1].y - corners_[i].y;
        if (height == 0)
            continue;
        const std::int32_t edge_sense = height > 0 ? 1 : -1;
        if (edge_sense != sense || i + 1 - begin > most_edges) {
            add_chain(begin, end);
            begin = i;
            sense = edge_sense;
        }
        end = i + 1;
    }
    add_chain(begin, end);
}

void OutlineStore::add_chain(std::int32_t first, std::int32_t last)
{
    if (first == last)
        return;
    const bool runs_up = corners_[last].y < corners_[first].y;
    const auto [upper, lower] = runs_up ? std::pair{last, first} : std::pair{first, last};
    if (is_outside(corners_[upper], corners_[lower]) || !find_room(0, 1))
        return;
    did(Work::chain);
    Chain& added = chain(chain_count_++);
    added = {};
    added.first = static_cast<std::uint16_t>(upper);
    added.edges = static_cast<std::uint16_t>(last - first) & most_edges;
    added.runs_up = runs_up ? 1 : 0;
}

bool OutlineStore::is_outside(Corner upper, Corner lower) const
{
    return (lower.y <= 0 || upper.y >= bottom_) && bottom_ != every_row * subrows;
}

OutlineRange OutlineStore::range_from(const OutlineRange& mark) const
{
    return {mark.first_corner, corner_count_, mark.first_chain, chain_count_};
}

// Shell sort: chains are few, mostly less than ten.
void OutlineStore::sort(const OutlineRange& range)
{
    const auto top = [this](std::int32_t i) { return corner(chain(static_cast<std::uint16_t>(i)).first).y; };
    const std::int32_t first = range.first_chain;
    const std::int32_t end = range.end_chain;
    std::int32_t gap = 1;
    while (gap < (end - first) / 3)
        gap = 3 * gap + 1;
    for (; gap > 0; gap /= 3)
        for (std::int32_t i = first + gap; i < end; ++i)
            for (std::int32_t j = i; j >= first + gap && top(j) < top(j - gap); j -= gap)
                std::swap(chain(static_cast<std::uint16_t>(j)), chain(static_cast<std::uint16_t>(j - gap)));
}

bool OutlineStore::is_equal(const OutlineRange& range, const OutlineStore& other,
                            const OutlineRange& others) const
{
    return range.end_chain - range.first_chain == others.end_chain - others.first_chain &&
           std::equal(corners_ + range.first_corner, corners_ + range.end_corner,
                      other.corners_ + others.first_corner, other.corners_ + others.end_corner);
}

OutlineRange OutlineStore::copy(const OutlineStore& from, const OutlineRange& range)
{
    const auto corners = static_cast<std::size_t>(range.end_corner - range.first_corner);
    const auto chains = static_cast<std::size_t>(range.end_chain - range.first_chain);
    OutlineRange copied = mark();
    if (!find_room(corners, chains))
        return copied;
    did(Work::copied_corner, static_cast<std::uint32_t>(corners));
    did(Work::copied_chain, static_cast<std::uint32_t>(chains));
    std::copy_n(from.corners_ + range.first_corner, corners, corners_ + corner_count_);
    std::copy_n(from.end_ - range.end_chain, chains, end_ - chain_count_ - chains);
    const auto shift = static_cast<std::uint16_t>(corner_count_ - range.first_corner);
    corner_count_ = static_cast<std::uint16_t>(corner_count_ + corners);
    chain_count_ = static_cast<std::uint16_t>(chain_count_ + chains);
    contour_ = corner_count_;
    for (std::uint16_t i = copied.first_chain; i < chain_count_; ++i)
        chain(i).first = static_cast<std::uint16_t>(chain(i).first + shift);
    return range_from(copied);
}

}
