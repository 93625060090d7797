#include "host/preview/files/gif_writing.hpp"

#include "host/picture/gif.hpp"
#include "host/picture/gif_moment.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace kfast {
namespace {

std::vector<Time> moments_of(const Timeline& timeline)
{
    std::vector<Time> moments;
    for (const GifMoment& moment : gif_moments(timeline))
        moments.push_back(moment.time);
    return moments;
}

/// Frames that are drawn already, as a source of pictures.
class DrawnFrames : public FrameSource {
public:
    DrawnFrames(const FrameCollection& frames, std::atomic<std::size_t>& shown,
                const std::atomic<bool>& is_stopped)
        : frames_{frames}, shown_{shown}, is_stopped_{is_stopped}
    {
    }

    void set_input(std::uint32_t, Time) override {}
    void set_text(std::uint32_t, std::string_view) override {}
    bool set_drawing(std::uint32_t, std::span<const InputStroke>) override { return true; }

    const Frame& show(Time moment) override
    {
        if (is_stopped_)
            throw Failure("stopped");
        ++shown_;
        return frames_.at(moment)->frame;
    }

private:
    const FrameCollection& frames_;
    std::atomic<std::size_t>& shown_;
    const std::atomic<bool>& is_stopped_;
};

}

GifWriting::GifWriting(std::filesystem::path target, const Timeline& timeline)
    : target_{std::move(target)}, timeline_{timeline}, frames_{moments_of(timeline)}
{
}

GifWriting::~GifWriting()
{
    is_stopped_ = true;
    if (written_all_.valid())
        written_all_.wait();
}

bool GifWriting::go_on(FrameSource& source)
{
    constexpr std::chrono::milliseconds patience{15};
    if (!frames_.is_complete()) {
        frames_.add_next(source);
        return false;
    }
    if (!written_all_.valid())
        written_all_ = std::async(std::launch::async, [this] {
            DrawnFrames drawn{frames_, written_, is_stopped_};
            write_gif(target_, drawn, timeline_);
        });
    if (written_all_.wait_for(patience) != std::future_status::ready)
        return false;
    written_all_.get();
    return true;
}

/// Each picture is looked at twice: for its colours, and to be written.
int GifWriting::percent() const
{
    return static_cast<int>(
        std::min((frames_.done() + written_) * 100 / (3 * frames_.total()), std::size_t{99}));
}

}
