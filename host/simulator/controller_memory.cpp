#include "host/simulator/controller_memory.hpp"

namespace kfast {

std::optional<std::string> AddressWindow::set(Axis axis, int first, int last, int limit)
{
    const std::string range = std::string{axis == Axis::columns ? "columns " : "rows "} +
                              std::to_string(first) + " to " + std::to_string(last);
    if (first > last)
        return range + ": reversed";
    if (last >= limit)
        return range + ": the last one is " + std::to_string(limit - 1);
    (axis == Axis::columns ? columns_
                           : rows_) = {.first = first, .last = last, .at = first, .is_given = true};
    restart();
    return std::nullopt;
}

void AddressWindow::restart()
{
    columns_.at = columns_.first;
    rows_.at = rows_.first;
    is_begun_ = false;
    is_full_ = false;
}

void AddressWindow::advance(Axis axis)
{
    Stretch& quick = axis == Axis::columns ? columns_ : rows_;
    Stretch& slow = axis == Axis::columns ? rows_ : columns_;
    is_begun_ = true;
    if (++quick.at <= quick.last)
        return;
    quick.at = quick.first;
    is_full_ = ++slow.at > slow.last;
}

}
