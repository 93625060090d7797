#include "host/fit/beam_run.hpp"

#include "host/fit/beam_fit.hpp"
#include "host/fit/op_log.hpp"

#include <algorithm>

namespace kfast::fit {
namespace {

int frames_in_turn(const PlayRange& stretch)
{
    const std::int32_t ticks = stretch.length().ticks * (stretch.loop == Loop::ping_pong ? 2 : 1);
    return (ticks + Time::ticks_per_frame - 1) / Time::ticks_per_frame;
}

}

BeamRun::BeamRun(const SceneView& scene, const Target& target)
    : stretch_{play_range_of(scene)}, frames_{frames_in_turn(stretch_)},
      stride_{(frames_ + max_frames - 1) / max_frames}, block_{BeamPlayer::block_bytes(scene, *target.beam)},
      player_{*BeamPlayer::create(scene, *target.beam, room_for_points(target), block_.bytes())}, inputs_{
                                                                                                      player_}
{
}

void BeamRun::visit_all(const VisitPicture& visit)
{
    for (int frame = 0; frame < frames_; frame += stride_)
        show(moment_of(frame), visit);
    if (stretch_.loop == Loop::once)
        show(stretch_.begin + stretch_.length(), visit);
    if (player_.scene().input_count() != 0)
        visit_busy(visit);
}

std::size_t BeamRun::frames_of_all() const
{
    const int with_inputs = player_.scene().input_count() == 0 ? 0 : std::max(frames_, BusyInputs::turn);
    return static_cast<std::size_t>((frames_ + with_inputs) / stride_);
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
