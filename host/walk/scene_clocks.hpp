#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace kfast {

/// The clocks of a scene, in their order.
class SceneClocks {
public:
    explicit SceneClocks(const SceneView& scene);

    std::size_t count() const { return clocks_.size(); }
    const Clock& operator[](std::size_t clock) const { return clocks_[clock]; }

    /// What all of them show at a time of the scene.
    std::vector<Time> at(Time time) const;

    /// A time of the scene, from 0 on, at which a clock comes to `shown`, or at which it starts if it begins
    /// there: that of its first pass or, if it ran before the scene began, of a later one. Within a tick.
    /// None if it never does, or if the clock that it goes by does not come to that place in its first pass.
    std::optional<Time> first_at(std::size_t clock, Time shown) const;

    /// The clock that a clock goes by, directly or by way of others, and that itself goes by the scene's
    /// time.
    std::size_t root_of(std::size_t clock) const;

private:
    std::vector<Clock> clocks_;
};

}
