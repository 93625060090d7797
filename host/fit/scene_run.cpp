#include "host/fit/scene_run.hpp"

#include "host/fit/beam_fit.hpp"
#include "host/fit/op_counts.hpp"
#include "host/walk/key_times.hpp"

#include <algorithm>

namespace kfast::fit {

namespace {

/// As in the scene, but what would end is repeated: it may be played again at any time.
PlayRange steady_stretch(const SceneView& scene)
{
    PlayRange stretch = play_range_of(scene);
    if (stretch.loop == Loop::once)
        stretch.loop = Loop::repeat;
    return stretch;
}

int frames_in_turn(const PlayRange& stretch)
{
    const std::int32_t ticks = stretch.length().ticks * (stretch.loop == Loop::ping_pong ? 2 : 1);
    return (ticks + Time::ticks_per_frame - 1) / Time::ticks_per_frame;
}

/// Every frame or, of a turn that is longer than `max_frames`, evenly spaced ones and those behind each key.
std::vector<int> visited_frames(const SceneView& scene, const PlayRange& stretch, int max_frames)
{
    const int frames = frames_in_turn(stretch);
    const int stride = (frames + max_frames - 1) / max_frames;
    std::vector<int> visited;
    for (int frame = 0; frame < frames; frame += stride)
        visited.push_back(frame);
    if (stride == 1)
        return visited;
    for (const Time key : shown_key_times(scene)) {
        const std::int32_t ticks = (key - stretch.begin).ticks + Time::ticks_per_frame - 1;
        if (const int frame = ticks / Time::ticks_per_frame; ticks >= 0 && frame < frames)
            visited.push_back(frame);
    }
    std::ranges::sort(visited);
    visited.erase(std::unique(visited.begin(), visited.end()), visited.end());
    return visited;
}

/// Never less than a row that the panel takes: whether the real ones hold it is checked elsewhere.
std::vector<std::byte> band_for(const Target& target)
{
    const Display& display = target.display;
    const std::size_t min =
        row_bytes(display.format, display.size.width) * static_cast<std::size_t>(display.granularity.height);
    return std::vector<std::byte>(std::max(target.band_bytes, min));
}

}

OpCounts FrameOps::work() const
{
    OpCounts sum{};
    for (const auto& [path, count] : by_item)
        sum += count;
    return sum;
}

SceneRun::SceneRun(const SceneView& scene, const Target& target, Fit fit)
    : target_{target},
      stretch_{steady_stretch(scene)},
      frames_{frames_in_turn(stretch_)},
      stride_{(frames_ + max_frames - 1) / max_frames},
      visited_{visited_frames(scene, stretch_, max_frames)},
      block_{Player::block_bytes(scene, target.display.size)},
      band_{band_for(target)},
      player_{*Player::create(scene, target.display.size, fit, block_.bytes())},
      inputs_{player_}
{
}

void SceneRun::visit_first(Time offset, const VisitFrame& visit)
{
    player_.redraw();
    draw(moment_of(0, offset), visit);
}

void SceneRun::visit_turn(Time offset, const VisitFrame& visit)
{
    const auto ignore = [](const FrameOps&) {};
    int shown = -1;
    for (const int frame : visited_) {
        if (frame == 0 || frame != shown + 1)
            draw(moment_of(frame == 0 ? frames_ - 1 : frame - 1, offset), ignore);
        draw(moment_of(frame, offset), visit);
        shown = frame;
    }
}

void SceneRun::visit_presses(const VisitFrame& visit)
{
    if (player_.scene().input_count() == 0)
        return;
    for (const Time place : {Time{}, whole_input, Time{}})
        put_inputs_and_draw(place, visit);
    inputs_.put_default();
}

void SceneRun::visit_turn_with_inputs(const VisitFrame& visit)
{
    if (player_.scene().input_count() == 0)
        return;
    const int turn = std::max(frames_, BusyInputs::turn);
    for (int frame = 0; frame < turn; frame += stride_) {
        if (frame == 0 || stride_ > 1) {
            inputs_.put(frame + turn - 1);
            draw(moment_of((frame + frames_ - 1) % frames_, {}), [](const FrameOps&) {});
        }
        inputs_.put(frame);
        draw(moment_of(frame % frames_, {}), visit);
    }
    inputs_.put_default();
}

std::size_t SceneRun::frames_of_all() const
{
    const int with_inputs = player_.scene().input_count() == 0 ? 0 : std::max(frames_, BusyInputs::turn);
    return 2 * visited_.size() + static_cast<std::size_t>(with_inputs / stride_);
}

void SceneRun::visit_noise(const VisitFrame& visit)
{
    if (InputDrawings::bytes_for(player_.scene()) == 0)
        return;
    inputs_.put_noise(0);
    draw(moment_of(0, {}), [](const FrameOps&) {});
    inputs_.put_noise(1);
    draw(moment_of(0, {}), visit);
    inputs_.put_default();
}

void SceneRun::put_inputs_and_draw(Time place, const VisitFrame& visit)
{
    inputs_.put_all(place);
    draw(moment_of(0, {}), visit);
}

void SceneRun::visit_end(const VisitFrame& visit)
{
    const SceneView& scene = player_.scene();
    if (scene.loop() != Loop::once)
        return;
    draw(moment_of(frames_ - 1, {}), [](const FrameOps&) {});
    draw(scene.length(), visit);
}

void SceneRun::draw(Time moment, const VisitFrame& visit)
{
    OpLog log;
    player_.show_moment(moment);
    std::size_t areas = 0;
    std::size_t bytes = 0;
    const Display& display = target_.display;
    const auto draw_all = [&]<PixelFormat format>() {
        const int area_bytes = static_cast<int>(display.window_bytes);
        for (;;) {
            const auto changes = player_.draw_changes<format>(band_, display.granularity, area_bytes);
            if (changes.empty())
                return;
            areas += changes.size();
            for (const Change& change : changes)
                bytes += change.pixels.size() + display.window_bytes;
        }
    };
    with_format(display.format, draw_all);
    if (!overfull_ && player_.picture().outlines.is_full())
        overfull_ = outlines_of(moment, player_.picture());
    visit({moment, log.by_item(), player_.picture(), areas, bytes, player_.unrecorded_bands()});
}

Time SceneRun::moment_of(int frame, Time offset) const
{
    const Time place = wrap(Time::frame(frame) + offset, stretch_.length(), stretch_.loop);
    return stretch_.begin + place;
}

BeamRun::BeamRun(const SceneView& scene, const Target& target)
    : stretch_{play_range_of(scene)},
      frames_{frames_in_turn(stretch_)},
      stride_{(frames_ + max_frames - 1) / max_frames},
      visited_{visited_frames(scene, stretch_, max_frames)},
      block_{BeamPlayer::block_bytes(scene, *target.beam)},
      player_{*BeamPlayer::create(scene, *target.beam, room_for_points(target), block_.bytes())},
      inputs_{player_}
{
}

void BeamRun::visit_all(const VisitPicture& visit)
{
    for (const int frame : visited_)
        show(moment_of(frame), visit);
    if (stretch_.loop == Loop::once)
        show(stretch_.begin + stretch_.length(), visit);
    if (player_.scene().input_count() != 0)
        visit_busy(visit);
}

std::size_t BeamRun::frames_of_all() const
{
    const int with_inputs = player_.scene().input_count() == 0 ? 0 : std::max(frames_, BusyInputs::turn);
    return visited_.size() + static_cast<std::size_t>(with_inputs / stride_);
}

void BeamRun::visit_busy(const VisitPicture& visit)
{
    for (const Time place : {Time{}, whole_input, Time{}}) {
        inputs_.put_all(place);
        show(moment_of(0), visit);
    }
    const int turn = std::max(frames_, BusyInputs::turn);
    for (int frame = 0; frame < turn; frame += stride_) {
        inputs_.put(frame);
        show(moment_of(frame % frames_), visit);
    }
    inputs_.put_noise(0);
    show(moment_of(0), visit);
    inputs_.put_default();
}

void BeamRun::show(Time moment, const VisitPicture& visit)
{
    OpLog log;
    player_.show_moment(moment);
    BeamPicture picture{.moment = moment, .report = player_.report()};
    for (const auto& [path, count] : log.by_item())
        picture.work += count;
    visit(picture);
}

Time BeamRun::moment_of(int frame) const
{
    return stretch_.begin + wrap(Time::frame(frame), stretch_.length(), stretch_.loop);
}

}
