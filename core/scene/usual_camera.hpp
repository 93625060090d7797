#pragma once

#include "core/math/size.hpp"
#include "core/scene/kfb_limits.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {

/// The distance of the viewer where a scene names none, in pixels: twice the longer side. From there the
/// canvas is seen within 28 degrees.
constexpr std::int32_t usual_camera(Size canvas)
{
    return std::max<std::int32_t>(kfb::min_camera, 2 * std::max(canvas.width, canvas.height));
}

}
