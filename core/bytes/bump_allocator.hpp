#pragma once

#include "core/bytes/expects.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// Hands out lent memory from the front.
class BumpAllocator {
public:
    explicit BumpAllocator(std::span<std::byte> block) : rest_{block} {}

    /// There must be that many bytes left.
    std::span<std::byte> cut(std::size_t bytes)
    {
        expects(bytes <= rest_.size());
        const std::span<std::byte> part = rest_.first(bytes);
        rest_ = rest_.subspan(bytes);
        return part;
    }

    template <class T>
    std::span<T> cut_as(std::size_t bytes)
    {
        return {reinterpret_cast<T*>(cut(bytes).data()), bytes / sizeof(T)};
    }

private:
    std::span<std::byte> rest_;
};

}
