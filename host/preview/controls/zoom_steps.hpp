#pragma once

namespace kfast {

/// The maximum of window pixels for a pixel of the panel.
inline constexpr int largest_zoom = 64;

/// The next useful zoom: above `scale` unless that is the largest, or below it but at least 1.
int next_larger_zoom(double scale);
int next_smaller_zoom(double scale);

}
