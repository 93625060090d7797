#include "host/svg/poses/pose_document.hpp"

#include <algorithm>
#include <utility>

namespace kfast::svg {
namespace {

/// Whether the last moment looks like the first one.
bool closes(const std::vector<Pose>& poses)
{
    return poses.size() == 1 || looks_like(poses.front().root, poses.back().root);
}

Ending ending_of(const std::vector<Pose>& poses, Ending asked)
{
    if (asked != Ending::automatic)
        return asked;
    return closes(poses) ? Ending::repeat : Ending::ping_pong;
}

/// The last drawing is there for a frame, unless a loop goes on with one that looks the same.
double length_of(const std::vector<Pose>& poses, Ending ending)
{
    const bool goes_on = ending == Ending::back_to_first || (ending == Ending::repeat && closes(poses));
    return std::max(poses.back().time + (goes_on ? 0 : 1), 1.0);
}

Loop loop_of(Ending ending)
{
    if (ending == Ending::once)
        return Loop::once;
    return ending == Ending::ping_pong ? Loop::ping_pong : Loop::repeat;
}

void go_back_to_first(std::vector<Pose>& poses)
{
    const double last = poses.back().time;
    const double step = poses.size() > 1 ? last - poses[poses.size() - 2].time : 1;
    Pose again = poses.front();
    again.time = last + step;
    poses.push_back(std::move(again));
}

}

art::Document document_of(const Picture& canvas, std::vector<Pose> poses, const KeyOptions& options,
                          art::Budget& budget, art::Losses& losses)
{
    const Ending ending = ending_of(poses, options.ending);
    if (ending == Ending::back_to_first)
        go_back_to_first(poses);
    art::Document document;
    document.width = canvas.width;
    document.height = canvas.height;
    document.background = canvas.background;
    document.frame_rate = options.frame_rate;
    document.frames = length_of(poses, ending);
    document.loop = loop_of(ending);
    document.nodes = nodes_of(poses, budget, losses);
    return document;
}

}
