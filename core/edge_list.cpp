#include "core/edge_list.hpp"

#include <array>
#include <utility>

namespace kfast {
namespace {

std::int32_t to_subrow(Fixed y) { return (y.raw() + 32) >> 6; }

constexpr int rest_bits = 8;

std::int64_t fine(Fixed value, std::uint8_t rest) { return (std::int64_t{value.raw()} << rest_bits) + rest; }

Fixed coarse(std::int64_t fine) { return Fixed::from_raw(static_cast<std::int32_t>(fine >> rest_bits)); }

std::uint8_t rest_of(std::int64_t fine) { return static_cast<std::uint8_t>(fine & ((1 << rest_bits) - 1)); }

/// Rounded towards minus infinity, for divisor > 0.
std::int64_t floor_divide(std::int64_t dividend, std::int32_t divisor)
{
    const std::int64_t quotient = dividend / divisor;
    return quotient - (quotient * divisor > dividend ? 1 : 0);
}

/// `top` and `bottom` are on different sub-rows.
Edge edge_between(Point top, Point bottom, bool runs_down)
{
    constexpr std::int32_t y_end_bits = (1 << 29) - 1; // only a masked value is sure to fit in a bit-field
    return {.x = top.x,
            .x_end = bottom.x,
            .slope = {},
            .y = to_subrow(top.y),
            .y_end = to_subrow(bottom.y) & y_end_bits,
            .winding = runs_down ? 1 : -1};
}

}

Fixed Edge::x_at(std::int32_t subrow) const { return coarse(fine_x_at(subrow)); }

void Edge::advance(std::int32_t subrow)
{
    const std::int64_t to = fine_x_at(subrow);
    x = coarse(to);
    x_rest = rest_of(to);
    y = subrow;
}

/// In 1/2^24 px.
std::int64_t Edge::fine_x_at(std::int32_t subrow) const
{
    const std::int32_t step = subrow - y;
    const std::int32_t height = y_end - y;
    if (step == height)
        return fine(x_end, 0);
    if (height >= subrows)
        return fine(x, x_rest) + (fine(slope, slope_rest) * step >> 10);
    const std::int32_t width = (x_end - x).raw(); // divided in 32 bits: less than a row is left
    return fine(x + Fixed::from_raw(width / height * step + width % height * step / height), x_rest);
}

void EdgeList::add(Layer& layer, Point from, Point to)
{
    const bool runs_down = to_subrow(from.y) < to_subrow(to.y);
    const Point top = runs_down ? from : to;
    const Point bottom = runs_down ? to : from;
    if (to_subrow(top.y) == to_subrow(bottom.y) || to_subrow(bottom.y) <= 0 || to_subrow(top.y) >= end_)
        return;
    if (count_++ >= storage_.size())
        return;
    Edge edge = edge_between(top, bottom, runs_down);
    const std::int32_t height = edge.y_end - edge.y;
    const std::int64_t width = std::int64_t{edge.x_end.raw()} - edge.x.raw();
    if (height >= subrows) {
        const std::int64_t slope = floor_divide(width * (subrows << rest_bits), height);
        edge.slope = coarse(slope);
        edge.slope_rest = rest_of(slope);
    }
    if (edge.y < 0) {
        edge.x = edge.x + Fixed::from_raw(static_cast<std::int32_t>(floor_divide(width * -edge.y, height)));
        edge.y = 0;
    }
    const auto index = static_cast<std::uint16_t>(count_ - 1);
    edge.next = std::exchange(layer.waiting, index);
    storage_[index] = edge;
}

// Merge sort of a linked list without recursion: bin k holds a sorted list of 2^k edges, or none.
void EdgeList::sort(Layer& layer)
{
    std::array<std::uint16_t, 16> bins;
    bins.fill(Layer::no_edge);
    while (layer.waiting != Layer::no_edge) {
        std::uint16_t run = std::exchange(layer.waiting, storage_[layer.waiting].next);
        storage_[run].next = Layer::no_edge;
        std::size_t bin = 0;
        for (; bins[bin] != Layer::no_edge; ++bin)
            run = merge(std::exchange(bins[bin], Layer::no_edge), run);
        bins[bin] = run;
    }
    for (const std::uint16_t run : bins)
        layer.waiting = merge(run, layer.waiting);
}

std::uint16_t EdgeList::merge(std::uint16_t first, std::uint16_t second)
{
    std::uint16_t head = Layer::no_edge;
    std::uint16_t* tail = &head;
    while (first != Layer::no_edge && second != Layer::no_edge) {
        std::uint16_t& lower = storage_[second].y < storage_[first].y ? second : first;
        *tail = lower;
        tail = &storage_[lower].next;
        lower = *tail;
    }
    *tail = first != Layer::no_edge ? first : second;
    return head;
}

}
