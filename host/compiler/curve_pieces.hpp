#pragma once

#include "host/scene/model.hpp"

#include <cstdint>

namespace kfast {

/// How many straight pieces stand for a curve anywhere on the way from `a` to `b`, so that none is more than
/// 1/32 px away from its curve; at least 1, at most kfb::max_curve_pieces.
std::uint32_t curve_pieces(const scene::Drawing& a, const scene::Drawing& b);

}
