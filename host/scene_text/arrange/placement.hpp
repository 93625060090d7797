#pragma once

#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"

#include <optional>
#include <vector>

namespace kfast::scene_text {

/// Whether it does nothing at all.
bool is_identity(const art::Transform& transform);
/// Whether it does the same all the time, within the plane of the canvas.
bool is_still(const art::Transform& transform);
/// Whether nothing rotates it out of the plane of the canvas.
bool lies_flat(const art::Transform& transform);
/// Whether it is skewed at any time.
bool is_skewed(const art::Transform& transform);

/// The components of an affine map that rotates and scales, perhaps unevenly or mirrored, but has no skew.
struct Placement {
    double x = 0;
    double y = 0;
    double rotate = 0; ///< degrees
    double scale_x = 1;
    double scale_y = 1;

    bool is_even() const; ///< scales equally in both directions, even if mirrored
    bool is_mirrored() const { return scale_x * scale_y < 0; }
    bool turns() const { return rotate != 0; }
};

std::optional<Placement> placement_of(const art::Affine& affine);
/// The transform about (0, 0).
art::Transform transform_of(const Placement& placement);

/// The scale of lengths, on average over all directions: the square root of that of areas.
double scale_factor_of(const art::Affine& affine);

/// How much longer than wide a circle becomes: 0 if it stays a circle.
double distortion_of(const art::Affine& affine);

/// The times at which both are visible.
std::vector<art::Span> common(const std::vector<art::Span>& one, const std::vector<art::Span>& other);

}
