#pragma once

#include "host/compiler/depth_bound.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// By what all that items lie in enlarges them at most, in any direction and at any moment: scales and
/// perspective.
class Enlargement {
public:
    /// Of the outermost items of the scene; `extents` must outlive it.
    static Enlargement outermost(const Extents& extents) { return {extents, 1, {}}; }
    /// Of what is not seen at all.
    static Enlargement unseen(const Extents& extents);

    /// Of `item` itself, if this is that of what it lies in.
    Enlargement inside(const scene::Item& item) const;
    /// Takes in that of another use of the same items.
    void cover(const Enlargement& other);

    double factor() const { return scale_ * perspective_bound(depth_, extents_->scene()); }

private:
    Enlargement(const Extents& extents, double scale, Depth depth)
        : extents_{&extents}, scale_{scale}, depth_{depth}
    {
    }

    const Extents* extents_;
    double scale_; ///< by scales alone
    Depth depth_;
};

/// Of the items of each symbol, over all of its uses and all that they lie in.
std::vector<Enlargement> symbol_enlargements(const Extents& extents);

}
