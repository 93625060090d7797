#include "host/preview/board/board_changes.hpp"

#include "host/fit/frame_cost.hpp"
#include "host/fit/op_counts.hpp"
#include "host/fit/scene_needs.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

std::int64_t pixels_of(const std::vector<Rect>& areas)
{
    std::int64_t pixels = 0;
    for (const Rect& area : areas)
        pixels += std::int64_t{area.width} * area.height;
    return pixels;
}

}

std::string SentAreas::text(Size panel) const
{
    const std::int64_t all = std::int64_t{panel.width} * panel.height;
    const std::int64_t rounded = (pixels_of(areas) * 100 + all / 2) / all;
    const std::int64_t share = areas.empty() ? 0 : std::max<std::int64_t>(rounded, 1);
    return counted(areas.size(), "area") + ", " + counted(bytes, "byte") + ", " + std::to_string(share) +
           " % of the panel";
}

BoardChanges::BoardChanges(const SceneView& scene, const fit::Target& board, Fit fit)
    : StandalonePlayer{scene, board.display.size, fit},
      display_{board.display},
      band_(std::max(board.band_bytes, fit::min_band(board.display)))
{
}

const SentAreas& BoardChanges::show(Time moment)
{
    if (!shown_ && moment > Time{})
        sent_for({moment.ticks - Time::ticks_per_frame});
    SentAreas sent = sent_for(moment);
    if (shown_ != moment || !sent.areas.empty())
        sent_ = std::move(sent);
    shown_ = moment;
    return sent_;
}

SentAreas BoardChanges::sent_for(Time moment)
{
    SentAreas sent;
    player().show_moment(moment);
    with_format(display_.format, [&]<PixelFormat format>() {
        for (;;) {
            const auto changes = player().draw_changes<format>(band_, display_.granularity,
                                                               static_cast<int>(display_.window_bytes));
            if (changes.empty())
                return;
            for (const Change& change : changes) {
                sent.areas.push_back(change.area);
                sent.bytes += change.pixels.size() + display_.window_bytes;
            }
        }
    });
    return sent;
}

BoardPace::BoardPace(const SceneView& scene, const fit::Target& board, Fit fit)
    : board_{board}, changes_{scene, board, fit}
{
}

double BoardPace::seconds_for(Time moment)
{
    using fit::operator+=;
    fit::OpLog log;
    const SentAreas& sent = changes_.show(moment);
    fit::FrameEffort effort{.moment = moment, .work = {}, .areas = sent.areas.size(), .bytes = sent.bytes};
    for (const auto& [path, count] : log.by_item())
        effort.work += count;
    return fit::cost_on(board_, effort).seconds();
}

}
