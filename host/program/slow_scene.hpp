#pragma once

#include <string_view>

namespace kfast {

/// What helps where Error::too_slow is told.
inline constexpr std::string_view slow_scene_hint =
    "show less at once, use symbols less often, or draw with fewer points";

}
