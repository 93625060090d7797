#pragma once

#include "host/geometry/outline.hpp"
#include "host/scene/model.hpp"
#include "host/scene/skeleton/binding.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// The points of a drawing that follow bones each in its own way. The closing point of a closed stroke
/// follows its first and does not count.
class SkinPoints {
public:
    explicit SkinPoints(const Drawing& drawing);

    const std::vector<Vec2>& spots() const { return spots_; }
    /// For each point as the format counts them; `bindings` are those of spots().
    std::vector<Binding> bindings_of_all(const std::vector<Binding>& bindings) const;

private:
    void add(const Stroke& stroke);
    void add(Point point);

    std::vector<Vec2> spots_;
    std::vector<std::size_t> all_; ///< indices into spots_
};

}
