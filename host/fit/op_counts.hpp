#pragma once

#include "core/bytes/op_counter.hpp"

#include <array>
#include <cstdint>

namespace kfast::fit {

/// How often each kind of work was done.
using OpCounts = std::array<std::uint32_t, op_kinds>;

inline OpCounts& operator+=(OpCounts& sum, const OpCounts& more)
{
    for (std::size_t kind = 0; kind < op_kinds; ++kind)
        sum[kind] += more[kind];
    return sum;
}

}
