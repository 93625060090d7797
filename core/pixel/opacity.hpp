#pragma once

#include "core/pixel/channel.hpp"

#include <cstdint>

namespace kfast {

/// a b / 255, rounded to nearest; all are 0 … 255.
constexpr std::uint32_t product_of_opacities(std::uint32_t a, std::uint32_t b)
{
    return rounded_255th(a * b);
}

}
