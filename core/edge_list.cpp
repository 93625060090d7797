#include "core/edge_list.hpp"

#include <array>
#include <utility>

namespace kfast {
namespace {

std::int32_t to_subrow(Fixed y) { return (y.raw() + 32) >> 6; }

/// numerator * factor / denominator, rounded towards minus infinity, for denominator > 0.
std::int32_t proportion(std::int32_t numerator, std::int32_t factor, std::int32_t denominator)
{
    const std::int64_t product = std::int64_t{numerator} * factor;
    const std::int64_t quotient = product / denominator;
    return static_cast<std::int32_t>(quotient - (product % denominator < 0 ? 1 : 0));
}

}

Fixed Edge::x_at(std::int32_t subrow) const
{
    const std::int32_t step = subrow - y;
    const std::int32_t height = y_end - y;
    if (step == height)
        return x_end;
    if (height >= subrows)
        return step == subrows ? x + slope : x + Fixed::from_raw(multiply(slope.raw(), step, 10));
    const std::int32_t width = (x_end - x).raw();
    return x + Fixed::from_raw(width / height * step + width % height * step / height);
}

void EdgeList::add(Layer& layer, Point from, Point to)
{
    Edge edge{.x = from.x, .x_end = to.x, .slope = {}, .y = to_subrow(from.y), .y_end = to_subrow(to.y)};
    edge.winding = 1;
    if (edge.y > edge.y_end) {
        std::swap(edge.x, edge.x_end);
        std::swap(edge.y, edge.y_end);
        edge.winding = -1;
    }
    if (edge.y == edge.y_end || edge.y_end <= 0 || edge.y >= end_)
        return;
    if (count_++ >= storage_.size())
        return;
    const std::int32_t width = (edge.x_end - edge.x).raw();
    const std::int32_t height = edge.y_end - edge.y;
    if (height >= subrows)
        edge.slope = Fixed::from_raw(proportion(width, subrows, height));
    if (edge.y < 0) {
        edge.x = edge.x + Fixed::from_raw(proportion(width, -edge.y, height));
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
