#include "core/prepared/key_timeline.hpp"

#include "core/bytes/op_counter.hpp"

namespace kfast {

void KeyTimeline::move_to(Time time, const SceneView& scene)
{
    count_op(Op::timeline);
    has_other_keys_ = time < begin_ || time >= end_;
    if (time < begin_)
        rewind(scene);
    if (time >= end_)
        go_on(time, scene);
    const ProgressXY before = progress_;
    progress_ = is_between_
                    ? progress_between(begin_, end_, time, scene.laws_at(laws_), scene.features().springs)
                    : ProgressXY{};
    const bool has_come_further = progress_ != before || (moves_with_time_ && is_between_ && time != now_);
    has_moved_ = has_other_keys_ || has_come_further;
    now_ = time;
}

bool KeyTimeline::is_held(const SceneView& scene) const
{
    const LawPair laws = scene.laws_at(laws_);
    return laws.x == VelocityLaw::hold && laws.y == VelocityLaw::hold;
}

KeyTimeCursor KeyTimeline::key_times(const SceneView& scene) const
{
    ByteReader bytes = scene.at(key_times_);
    return KeyTimeCursor::take(bytes, {});
}

/// The key times after the key at the end of the interval.
KeyTimeCursor KeyTimeline::key_times_behind(const SceneView& scene) const
{
    KeyTimeCursor behind = key_times(scene);
    behind.go_on_behind({.time = end_, .index = to()});
    return behind;
}

/// Goes to before the first key.
void KeyTimeline::rewind(const SceneView& scene)
{
    KeyTimeCursor all = key_times(scene);
    const KeyTime first = all.next();
    begin_ = always;
    end_ = first.time;
    next_laws_ = static_cast<std::uint8_t>(first.laws);
    from_ = 0;
    is_between_ = false;
}

/// Goes to the last key that is not after `time`: at least one.
void KeyTimeline::go_on(Time time, const SceneView& scene)
{
    KeyTimeCursor behind = key_times_behind(scene);
    std::uint32_t laws = 0;
    while (time >= end_) {
        before_ = is_between_ ? begin_ : end_;
        from_ += is_between_ ? 1 : 0;
        begin_ = end_;
        laws = next_laws_;
        is_between_ = !behind.at_end();
        const KeyTime next = is_between_ ? behind.next() : KeyTime{.time = never};
        end_ = next.time;
        next_laws_ = static_cast<std::uint8_t>(next.laws);
    }
    laws_ = scene.place_of_laws(laws);
}

Time KeyTimeline::time_after(const SceneView& scene) const
{
    KeyTimeCursor behind = key_times_behind(scene);
    return behind.at_end() ? end_ : behind.next().time;
}

}
