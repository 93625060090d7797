#include "core/row_parts.hpp"

#include "core/work.hpp"

namespace kfast {
namespace {

/// How far the slope may change, in 1/65536 px a row: the triangle between a bend and its chord then has 1/64
/// of a pixel's area at most.
constexpr std::uint32_t slight_bend = Fixed::one / 8;

/// Where edges are less than a row high, nothing tells their slopes. Those of others lie within ±32766 px, so
/// that no two of them are near to each other only because their difference does not fit.
bool is_slight(std::int32_t slope, std::int32_t other)
{
    return static_cast<std::uint32_t>(slope) - static_cast<std::uint32_t>(other) + slight_bend <=
           2 * slight_bend;
}

void stretch(RowPart& part, std::int32_t x)
{
    part.left = std::min(part.left, x);
    part.right = std::max(part.right, x);
}

}

bool RowParts::find()
{
    const Layer& layer = line_.layer();
    for (std::uint16_t i = layer.active; i != Chain::none; i = line_.chain(i).next) {
        if (count_ == most)
            return false;
        add_under_way(i);
    }
    for (std::uint16_t i = layer.waiting; i != layer.outlines.end_chain && line_.top_of(i) < bottom_; ++i) {
        if (count_ == most)
            return false;
        add_beginning(i);
    }
    return true;
}

void RowParts::add_under_way(std::uint16_t number)
{
    RowPart& part = begin_part(number, line_.chain(number));
    const ChainEdge edge = current_edge(line_.store(), *part.chain);
    part.is_straight = edge.lower->y > bottom_;
    if (part.is_straight) { // mostly
        did(Work::straight_part);
        part.end_at(part.begin + part.chain->slope);
    } else {
        part.top = top_;
        bend(part, edge);
    }
    put_in_order(part);
}

void RowParts::add_beginning(std::uint16_t number)
{
    Chain& chain = line_.chain(number);
    line_.begin(chain);
    RowPart& part = begin_part(number, chain);
    const ChainEdge edge = current_edge(line_.store(), chain);
    part.is_straight = false;
    part.top = edge.upper->y;
    bend(part, edge);
    put_in_order(part);
}

RowPart& RowParts::begin_part(std::uint16_t number, Chain& chain)
{
    RowPart& part = parts_[count_];
    part.number = number;
    part.chain = &chain;
    part.corners = 0;
    part.is_over = false;
    part.begin = chain.x.raw();
    return part;
}

/// One that does not go straight on, from its `edge` at the top.
void RowParts::bend(RowPart& part, const ChainEdge& edge)
{
    did(Work::bent_part);
    part.bottom = bottom_;
    if (edge.lower->y > bottom_)
        part.end_at(edge.x_at(bottom_, part.chain->slope).raw());
    else
        follow(part, edge);
    run_through_ = run_through_ && runs_through(part);
}

/// The order depends on nothing but where parts lie: however the sweep came to the row, it is the same.
void RowParts::put_in_order(RowPart& part)
{
    if (count_ != 0 && part.left < order_[count_ - 1]->right)
        return put_between(part);
    order_[count_++] = &part;
}

void RowParts::put_between(RowPart& part)
{
    std::size_t at = count_++;
    came_apart_ = false;
    const auto is_left_of = [&part](const RowPart& other) {
        return part.left < other.left || (part.left == other.left && part.right < other.right);
    };
    for (; at > 0 && is_left_of(*order_[at - 1]); --at)
        order_[at] = order_[at - 1];
    order_[at] = &part;
}

/// From `edge` past all corners down to the lower border of the row.
void RowParts::follow(RowPart& part, ChainEdge edge) const
{
    const Chain& chain = *part.chain;
    const Corner& first = *edge.lower;
    const std::ptrdiff_t onward = chain.runs_up != 0 ? -1 : 1;
    const std::uint32_t edges_left = chain.edges - std::uint32_t{chain.passed};
    const bool begins_high = edge.height() >= subrows;
    part.left = part.right = part.begin;
    do {
        did(Work::edge);
        stretch(part, edge.lower->x.raw());
        part.is_over = ++part.corners == edges_left;
        if (part.is_over) {
            part.end = edge.lower->x.raw();
            part.bottom = edge.lower->y;
            break;
        }
        edge = {edge.lower, edge.lower + onward};
    } while (edge.lower->y <= bottom_);
    if (!part.is_over) {
        part.next_slope = edge.height() >= subrows ? row_slope(edge) : 0;
        part.end = part.next_x = edge.x_at(bottom_, part.next_slope).raw();
        stretch(part, part.end);
    }
    if (part.top != top_)
        return;
    if (first.y == bottom_) {
        part.end = first.x.raw();
        part.is_straight = true;
    } else {
        part.is_straight = part.corners == 1 && !part.is_over && begins_high && edge.height() >= subrows &&
                           is_slight(part.next_slope, chain.slope);
    }
    if (part.is_straight)
        part.end_at(part.end);
}

bool RowParts::lie_apart() const
{
    for (std::size_t i = came_apart_ ? count_ : 1; i < count_; ++i)
        if ((*this)[i].left < (*this)[i - 1].right)
            return false;
    return true;
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
