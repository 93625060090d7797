#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "host/compiler/limits/measured_moments.hpp"
#include "host/walk/scene_clocks.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace kfast {

/// How the clocks of a long scene may meet. Each one that repeats or turns back comes to all of its times
/// again and again, together with any time of the others whose periods differ: too rarely for samples of the
/// scene's time. So they are varied apart from each other, and from the rest of the scene. Clocks that go by
/// the same one, or that have the same period, keep their distance and are varied together.
class ClockPhases {
public:
    explicit ClockPhases(const SceneView& scene);

    /// Whether there is anything to vary: clocks that repeat, in a scene of more than `max_frames`.
    bool are_varied() const { return !groups_.empty(); }

    /// Looks for the phases at which a picture needs most bytes, starting from `moment`: of each group in
    /// turn the one of at most `max_pictures` in all with which it does. bytes_at(moment) tells what is
    /// needed.
    void vary(MeasuredMoment moment, std::size_t max_pictures,
              const std::function<std::size_t(const MeasuredMoment&)>& bytes_at) const;

private:
    static constexpr int max_frames = 1000; ///< as far as four samples of a frame go

    /// Clocks that keep their distance, and times of the scene at which their keys are.
    struct Group {
        Clock root;
        std::vector<std::size_t> clocks;
        std::vector<Time> times;
    };

    Group& group_of(const Clock& root);
    void put(const Group& group, Time time, std::vector<Time>& shown) const;

    SceneClocks clocks_;
    std::vector<Group> groups_;
};

}
