#include "host/commands/render/contact_prints.hpp"

#include "host/picture/picture.hpp"
#include "host/program/failure.hpp"
#include "host/text/number_text.hpp"
#include "host/walk/key_times.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

constexpr int smallest_side = 16; ///< of a picture in which anything is to be seen

std::vector<Time> played_keys(const SceneView& scene, const PlayRange& stretch)
{
    std::vector<Time> times;
    for (const Time time : shown_key_times(scene))
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

Size divided(Size size, int divisor)
{
    return {(size.width + divisor - 1) / divisor, (size.height + divisor - 1) / divisor};
}

}

std::vector<ContactMoment> contact_moments(const SceneView& scene, const Timeline& timeline)
{
    std::vector<ContactMoment> moments;
    for (const Time time : played_keys(scene, timeline.stretch))
        moments.push_back({time, label(time, timeline)});
    return moments;
}

ContactPlan contact_plan(const std::vector<ContactMoment>& moments, Size picture, int scale)
{
    std::size_t longest_label = 0;
    for (const ContactMoment& moment : moments)
        longest_label = std::max(longest_label, moment.label.size());
    Size smaller = picture;
    for (int divisor = 1; divisor == 1 || std::max(smaller.width, smaller.height) >= smallest_side;
         ++divisor) {
        smaller = divided(picture, divisor);
        if (const auto layout = contact_layout(moments.size(), smaller, longest_label, scale))
            return {smaller, divisor, *layout};
    }
    throw Failure("a contact sheet has no room for " + std::to_string(moments.size()) +
                  " keys, however small their pictures: sides of " + std::to_string(longest_picture_side) +
                  " pixels and " + std::to_string(max_picture_pixels) +
                  " pixels in all are possible; play less with --clip, or choose a smaller --scale");
}

std::vector<ContactPrint> contact_prints(const std::vector<ContactMoment>& moments, FrameSource& source,
                                         const ProgressCallback& on_progress)
{
    std::vector<ContactPrint> prints;
    for (const auto& [time, text] : moments) {
        on_progress(prints.size(), moments.size());
        prints.push_back({widen(source.show(time)), text});
    }
    return prints;
}

}
