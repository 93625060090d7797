#pragma once

#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// Between what coordinates something lies at every moment, in pixels.
struct Extent {
    double least = 0;
    double most = 0;

    bool is_empty() const { return least > most; }
};

struct ExtentXY {
    Extent x;
    Extent y;
};

/// How far something lies from a pivot at most, in pixels.
struct Reach {
    double x = 0;
    double y = 0;
};

/// Bounds on where the things of a scene lie in the planes they are drawn in. What bones or backbones carry
/// is taken to lie on the canvas. Turns about x and y only make things narrower.
class Extents {
public:
    /// `scene` must outlive the extents.
    explicit Extents(const scene::Scene& scene);

    const scene::Scene& scene() const { return *scene_; }
    /// Of what lies in `item`, in its own plane: before it is scaled, turned and moved. Empty if nothing
    /// does.
    ExtentXY inside(const scene::Item& item) const;
    /// That of it from the item's pivot, scaled and turned about z.
    Reach from_pivot(const scene::Item& item) const { return from_pivot(item, inside(item)); }

private:
    /// `own` is what lies in the item.
    static Reach from_pivot(const scene::Item& item, const ExtentXY& own);
    ExtentXY around(const scene::Item& item) const;
    ExtentXY of_all(const std::vector<scene::Item>& items) const;

    const scene::Scene* scene_;
    std::vector<ExtentXY> symbols_; ///< of their items
};

}
