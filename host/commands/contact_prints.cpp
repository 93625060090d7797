#include "host/commands/contact_prints.hpp"

#include "host/in_frames.hpp"
#include "host/preview/key_times.hpp"
#include "host/rounded_text.hpp"

#include <cmath>

namespace kfast {
namespace {

std::vector<Time> played_keys(const SceneView& scene, const Stretch& stretch)
{
    std::vector<Time> times;
    for (const Time time : key_times(scene))
        if (time >= stretch.begin && time <= stretch.end)
            times.push_back(time);
    return times.empty() ? std::vector<Time>{stretch.begin} : times;
}

/// "12  0.4 s"
std::string label(Time time, const Timeline& timeline)
{
    const double frame = in_frames(time);
    const double seconds = std::round(timeline.seconds(time.ticks) * 1000) / 1000;
    return rounded_text(std::round(frame * 100) / 100) + "  " + rounded_text(seconds) + " s";
}

}

std::vector<ContactPrint> contact_prints(const SceneView& scene, const Timeline& timeline,
                                         FrameSource& source, const TellWork& tell)
{
    const std::vector<Time> times = played_keys(scene, timeline.stretch);
    std::vector<ContactPrint> prints;
    for (const Time time : times) {
        tell(prints.size(), times.size());
        prints.push_back({widen(source.show(time)), label(time, timeline)});
    }
    return prints;
}

}
