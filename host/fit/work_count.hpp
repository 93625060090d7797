#pragma once

#include "core/bytes/work.hpp"

#include <array>
#include <cstdint>

namespace kfast::fit {

/// How often each kind of work was done.
using WorkCount = std::array<std::uint32_t, work_kinds>;

inline WorkCount& operator+=(WorkCount& sum, const WorkCount& more)
{
    for (std::size_t kind = 0; kind < work_kinds; ++kind)
        sum[kind] += more[kind];
    return sum;
}

}
