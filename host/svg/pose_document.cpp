#include "host/svg/pose_document.hpp"

#include <algorithm>
#include <utility>

namespace kfast::svg {
namespace {

Ending ending_of(const std::vector<Pose>& poses, Ending asked)
{
    if (asked != Ending::automatic)
        return asked;
    const bool closes = poses.size() == 1 || looks_like(poses.front().root, poses.back().root);
    return closes ? Ending::repeat : Ending::ping_pong;
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
    document.frames = std::max(poses.back().time, 1.0);
    document.loop = loop_of(ending);
    document.nodes = nodes_of(poses, budget, losses);
    return document;
}

}
