#include "core/row_parts.hpp"

#include "core/work.hpp"

#include <cstdlib>

namespace kfast {
namespace {

/// How far the slope may change, in 1/65536 px a row: the triangle between a bend and its chord then has 1/64
/// of a pixel's area at most.
constexpr std::int32_t slight_bend = Fixed::one / 8;

void stretch(RowPart& part, std::int32_t x)
{
    part.left = std::min(part.left, x);
    part.right = std::max(part.right, x);
}

}

bool RowParts::find()
{
    const Layer& layer = line_.layer();
    for (std::uint16_t i = layer.active; i != Chain::none; i = line_.chain(i).next)
        if (!add(i, true))
            return false;
    for (std::uint16_t i = layer.waiting; i != layer.outlines.end_chain && line_.top_of(i) < bottom_; ++i) {
        line_.begin(line_.chain(i));
        if (!add(i, false))
            return false;
    }
    return true;
}

bool RowParts::add(std::uint16_t number, bool is_under_way)
{
    if (count_ == most)
        return false;
    RowPart& part = parts_[count_];
    Chain& chain = line_.chain(number);
    const std::int32_t end = edge_end(line_.store(), chain);
    part.number = number;
    part.chain = &chain;
    part.corners = 0;
    part.is_over = false;
    part.begin = chain.x.raw();
    part.is_straight = is_under_way && end > bottom_;
    if (part.is_straight) { // mostly
        did(Work::straight_part);
        part.end_at(part.begin + chain.slope);
    } else {
        did(Work::bent_part);
        part.top = is_under_way ? top_ : line_.top_of(number);
        part.bottom = bottom_;
        if (end > bottom_)
            part.end_at(current_edge(line_.store(), chain).x_at(bottom_, chain.slope).raw());
        else
            follow(part);
        run_through_ = run_through_ && runs_through(part);
    }
    put_in_order(part);
    return true;
}

/// The order depends on nothing but where parts lie: however the sweep came to the row, it is the same.
void RowParts::put_in_order(RowPart& part)
{
    std::size_t at = count_++;
    if (at == 0 || part.left >= order_[at - 1]->right) { // mostly
        order_[at] = &part;
        return;
    }
    came_apart_ = false;
    const auto is_left_of = [&part](const RowPart& other) {
        return part.left < other.left || (part.left == other.left && part.right < other.right);
    };
    for (; at > 0 && is_left_of(*order_[at - 1]); --at)
        order_[at] = order_[at - 1];
    order_[at] = &part;
}

/// Past all corners down to the lower border of the row.
void RowParts::follow(RowPart& part) const
{
    const OutlineStore& store = line_.store();
    Chain below = *part.chain;
    const Corner* corner;
    part.left = part.right = part.begin;
    do {
        corner = current_edge(store, below).lower;
        stretch(part, corner->x.raw());
        ++part.corners;
        part.is_over = ++below.passed == below.edges;
        if (part.is_over)
            break;
        enter_edge(store, below);
    } while (edge_end(store, below) <= bottom_);
    if (part.is_over) {
        part.end = corner->x.raw();
        part.bottom = corner->y;
    } else {
        part.end = part.next_x = current_edge(store, below).x_at(bottom_, below.slope).raw();
        part.next_slope = below.slope;
        stretch(part, part.end);
    }
    if (part.top != top_)
        return;
    const Corner& first = *current_edge(store, *part.chain).lower;
    if (first.y == bottom_)
        part.end = first.x.raw();
    part.is_straight =
        first.y == bottom_ || (part.corners == 1 && !part.is_over && bend_slightly(*part.chain, below));
    if (part.is_straight)
        part.end_at(part.end);
}

/// Where edges are less than a row high, nothing tells their slopes.
bool RowParts::bend_slightly(const Chain& above, const Chain& below) const
{
    const auto is_high = [this](const Chain& chain) {
        return current_edge(line_.store(), chain).height() >= subrows;
    };
    return is_high(above) && is_high(below) &&
           std::abs(std::int64_t{below.slope} - above.slope) <= slight_bend;
}

bool RowParts::stand_apart() const
{
    for (std::size_t i = came_apart_ ? count_ : 1; i < count_; ++i)
        if ((*this)[i].left < (*this)[i - 1].right)
            return false;
    return run_through_ || come_in_pairs();
}

bool RowParts::come_in_pairs() const
{
    for (std::size_t i = 0; i < count_; ++i) {
        const RowPart& a = (*this)[i];
        if (runs_through(a))
            continue;
        if (++i == count_)
            return false;
        const RowPart& b = (*this)[i];
        if (runs_through(b) || b.top != a.top || b.bottom != a.bottom ||
            b.chain->winding() + a.chain->winding() != 0)
            return false;
    }
    return true;
}

}
