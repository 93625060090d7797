// The functions of a viewer that take long: all frames in memory, or in a file.

#include "host/preview/viewer/viewer.hpp"

#include "host/preview/files/written_files.hpp"
#include "host/text/number_text.hpp"

#include <utility>

namespace kfast {
namespace {

namespace fs = std::filesystem;

std::vector<Time> moments_of_frames(const Timeline& timeline)
{
    std::vector<Time> moments;
    moments.reserve(static_cast<std::size_t>(timeline.frame_count()));
    for (int frame = 0; frame < timeline.frame_count(); ++frame)
        moments.push_back(timeline.frame_time(frame));
    return moments;
}

}

const FrameCollection* Viewer::frames_in_work() const
{
    return all_frames_ && !all_frames_->is_complete() ? &*all_frames_ : nullptr;
}

std::optional<double> Viewer::progress() const
{
    if (gif_ != nullptr)
        return gif_->percent() / 100.0;
    if (const FrameCollection* frames = frames_in_work())
        return static_cast<double>(frames->done()) / static_cast<double>(frames->total());
    return std::nullopt;
}

void Viewer::stop_work()
{
    if (!is_working())
        return;
    notify(gif_ != nullptr ? "stopped: no GIF is written" : "stopped: not all frames are generated");
    gif_.reset();
    if (frames_in_work() != nullptr)
        all_frames_.reset();
}

/// If not, the notice says why.
bool Viewer::fits_in_memory(std::size_t frames)
{
    const std::size_t bytes = frame().pixels.size() * frames;
    if (bytes <= FrameCollection::max_bytes)
        return true;
    notify(counted(frames, "frame") + " would need " + std::to_string(bytes >> 20) + " MB of memory, and " +
           std::to_string(FrameCollection::max_bytes >> 20) +
           " are the most: choose a clip (c) or a smaller --size");
    return false;
}

void Viewer::generate_all_frames()
{
    if (all_frames_) {
        all_frames_.reset();
        return;
    }
    Timeline timeline = playback_->timeline();
    timeline.speed = Playhead::as_authored; // as space steps
    std::vector<Time> moments = moments_of_frames(timeline);
    if (!fits_in_memory(moments.size()))
        return;
    playback_->scrub(playback_->time());
    all_frames_.emplace(std::move(moments));
}

void Viewer::begin_gif()
{
    const std::string& clip = playback_->part().name;
    const fs::path target =
        new_output_name(shown_.scene->file, clip.empty() ? "" : '-' + plain_name(clip), ".gif");
    auto gif = std::make_unique<GifWriting>(target, playback_->timeline());
    if (fits_in_memory(gif->frames()))
        gif_ = std::move(gif);
}

void Viewer::go_on_working()
{
    apply_playback(*shown_.scene->source, *playback_);
    if (gif_ == nullptr) {
        all_frames_->add_next(*shown_.scene->source);
        notify(all_frames_->is_complete()
                   ? counted(all_frames_->total(), "frame") + ": space steps, 'a' ends that"
                   : "frame " + std::to_string(all_frames_->done()) + " of " +
                         std::to_string(all_frames_->total()) + ": any key stops that");
        return;
    }
    try {
        notify("writing " + gif_->target().string() + ": " + std::to_string(gif_->percent()) +
               " %, any key stops that");
        if (gif_->go_on(*shown_.scene->source)) {
            notify(gif_->target().string() + " is written");
            gif_.reset();
        }
    } catch (const std::exception& failure) { // the scene goes on
        notify(failure.what());
        gif_.reset();
    }
}

}
