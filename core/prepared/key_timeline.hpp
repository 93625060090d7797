#pragma once

#include "core/scene/scene_view.hpp"
#include "core/scene/track_view.hpp"
#include "core/time/time.hpp"
#include "core/time/track.hpp"

#include <cstdint>
#include <limits>

namespace kfast {

/// Key times of a scene, and the position of a time among them: between which two of them it is, and the
/// progress from the one to the other. Each set of key times that the scene stores has one: tracks of an item
/// and bones of a skeleton share it where the file says so.
///
/// It continues from its position: only a time before the present key makes it begin anew.
class KeyTimeline {
public:
    /// At no time yet. `key_times` is the offset in the scene's bytes of at least two key times.
    KeyTimeline(std::uint32_t key_times, Driver driver) : key_times_{key_times}, driver_{driver} {}

    /// It changes with every time between two keys, whatever their laws: something follows a smooth curve.
    void move_with_time() { moves_with_time_ = true; }

    /// Moves to a time of its driver. `scene` has its key times and laws.
    void move_to(Time time, const SceneView& scene);

    Driver driver() const { return driver_; }
    /// All of its key times.
    KeyTimeCursor key_times(const SceneView& scene) const;

    /// Whether the values of the keys do not change up to the next of them.
    bool is_held(const SceneView& scene) const;

    Time now() const { return now_; }
    /// Whether the time is neither before the first key nor from the last one on.
    bool is_between() const { return is_between_; }
    /// The numbers of both keys: the same one twice where it is not between two.
    std::uint32_t from() const { return from_; }
    std::uint32_t to() const { return from_ + (is_between_ ? 1 : 0); }
    const ProgressXY& progress() const { return progress_; }
    Progress progress(LawAxis axis) const { return axis == LawAxis::y ? progress_.y : progress_.x; }
    /// The times of both keys, of the one before and of the one after; only between two keys, and the same
    /// one again where there is none.
    Time from_time() const { return begin_; }
    Time to_time() const { return end_; }
    Time time_before() const { return before_; }
    Time time_after(const SceneView& scene) const;

    /// Whether the last move changed the keys.
    bool has_other_keys() const { return has_other_keys_; }
    /// Whether it did, or the progress has changed.
    bool has_moved() const { return has_moved_; }

private:
    static constexpr Time never{std::numeric_limits<std::int32_t>::max()};
    static constexpr Time always{std::numeric_limits<std::int32_t>::min()};

    void rewind(const SceneView& scene);
    void go_on(Time time, const SceneView& scene);
    KeyTimeCursor key_times_behind(const SceneView& scene) const;

    std::uint32_t key_times_;
    // Within these nothing is read.
    Time begin_ = never;
    Time end_ = always;
    Time before_;
    Time now_;
    ProgressXY progress_;
    std::uint32_t from_ = 0;
    std::uint16_t laws_ = 0;     ///< for the interval between the two keys: SceneView::place_of_laws()
    std::uint8_t next_laws_ = 0; ///< number of the pair for the interval that follows
    Driver driver_;
    bool is_between_ = false;
    bool moves_with_time_ = false;
    bool has_other_keys_ = false;
    bool has_moved_ = false;
};

static_assert(sizeof(KeyTimeline) == 40 && alignof(KeyTimeline) == 4);

}
