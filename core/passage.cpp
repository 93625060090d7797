#include "core/passage.hpp"

namespace kfast {

Passage passage_between(const SceneView& scene, const KeyInterval<TrackKey>& keys, LawAxis axis, Time time)
{
    const auto& [from, to] = keys;
    if (from.value == to.value)
        return {from.value, from.value, {}};
    const Progress progress = progress_between(from.time, to.time, time, scene.laws(from.laws));
    return {from.value, to.value, axis == LawAxis::y ? progress.y : progress.x};
}

Passage passage_at(const SceneView& scene, TrackKeyCursor keys, LawAxis axis, Time time)
{
    return passage_between(scene, interval_at(keys, time), axis, time);
}

}
