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
/// Whether nothing turns it out of the plane of the canvas.
bool lies_flat(const art::Transform& transform);
/// Whether it leans at any time.
bool is_skewed(const art::Transform& transform);

/// What an affine map is made of, if it turns and grows, perhaps unevenly or mirrored, but does not lean.
struct Placement {
    double x = 0;
    double y = 0;
    double rotate = 0; ///< degrees
    double scale_x = 1;
    double scale_y = 1;

    bool is_even() const; ///< grows alike in both directions, if mirrored
    bool is_mirrored() const { return scale_x * scale_y < 0; }
    bool turns() const { return rotate != 0; }
};

std::optional<Placement> placement_of(const art::Affine& affine);
/// About (0, 0).
art::Transform transform_of(const Placement& placement);

/// How much larger lengths become, on average over all directions: the square root of what areas grow by.
double scale_factor_of(const art::Affine& affine);

/// By how much a circle becomes longer than it is wide: 0 if it stays one.
double distortion_of(const art::Affine& affine);

/// When both are seen.
std::vector<art::Span> common(const std::vector<art::Span>& one, const std::vector<art::Span>& other);

}
