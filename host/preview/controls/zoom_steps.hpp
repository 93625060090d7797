#pragma once

namespace kfast {

/// Window pixels for a pixel of the panel, at most.
inline constexpr int largest_zoom = 64;

/// The next zoom that is worth having: above `scale` unless that is the largest, or below it but at least 1.
int next_larger_zoom(double scale);
int next_smaller_zoom(double scale);

}
