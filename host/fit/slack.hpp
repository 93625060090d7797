#pragma once

namespace kfast::fit {

/// For figures that were rounded, as a factor: 16.667 ms are 60 fps.
inline constexpr double slack = 1.0001;

}
