#include "host/preview/board_pace.hpp"

#include "host/fit/frame_cost.hpp"
#include "host/fit/work_log.hpp"

namespace kfast {

BoardPace::BoardPace(const SceneView& scene, const fit::Target& board, Fit fit)
    : board_{board}, changes_{scene, board, fit}
{
}

double BoardPace::seconds_for(Time moment)
{
    using fit::operator+=;
    fit::WorkLog log;
    const SentAreas& sent = changes_.show(moment);
    fit::FrameEffort effort{.moment = moment, .work = {}, .areas = sent.areas.size(), .bytes = sent.bytes};
    for (const auto& [path, count] : log.by_item())
        effort.work += count;
    return fit::cost_on(board_, effort).seconds();
}

}
