#include "host/preview/files/written_files.hpp"

#include "host/picture/film.hpp"
#include "host/picture/gif.hpp"
#include "host/picture/timeline.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <chrono>
#include <unistd.h>
#include <utility>

namespace kfast {

namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& file)
{
    std::error_code unknown;
    return fs::exists(fs::symlink_status(file, unknown));
}

/// The folder for new files.
fs::path folder_beside(const fs::path& scene)
{
    const fs::path folder = scene.parent_path();
    return folder.empty() || ::access(folder.c_str(), W_OK | X_OK) == 0 ? folder : fs::path{};
}

bool is_plain(char letter)
{
    constexpr std::string_view harmless = "-_.";
    const auto byte = static_cast<unsigned char>(letter);
    const bool is_ascii_word = (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
                               (letter >= 'A' && letter <= 'Z');
    return is_ascii_word || byte >= 0x80 || harmless.find(letter) != std::string_view::npos;
}

}

fs::path new_output_name(const fs::path& scene, const std::string& suffix, const std::string& extension)
{
    std::error_code unknown;
    const bool is_file = fs::is_regular_file(scene, unknown);
    const std::string stem = is_file ? scene.stem().string() : "scene";
    const fs::path folder = is_file ? folder_beside(scene) : fs::path{};
    fs::path name = folder / (stem + suffix + extension);
    for (int number = 2; is_there(name); ++number)
        name = folder / (stem + suffix + '-' + std::to_string(number) + extension);
    return name;
}

std::string frame_suffix(int frame) { return '-' + frame_digits(frame); }

std::string plain_name(std::string_view name)
{
    std::string plain{name};
    std::ranges::replace_if(
        plain, [](char letter) { return !is_plain(letter); }, '_');
    return plain;
}

FrameCollection::FrameCollection(std::vector<Time> moments) : moments_{std::move(moments)}
{
    std::ranges::sort(moments_);
    moments_.erase(std::unique(moments_.begin(), moments_.end()), moments_.end());
}

void FrameCollection::add_next(FrameSource& source)
{
    const Frame& frame = source.show(moments_[done()]);
    frames_.push_back({frame, source.facts()});
}

const FrameCollection::Drawn* FrameCollection::at(Time moment) const
{
    const auto place = std::ranges::lower_bound(moments_, moment);
    const auto index = static_cast<std::size_t>(place - moments_.begin());
    const bool is_known = place != moments_.end() && *place == moment && index < done();
    return is_known ? &frames_[index] : nullptr;
}

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

    bool set(std::uint32_t, const InputContent&) override { return true; }

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

/// Each picture is read twice: for its colours, and to be written.
int GifWriting::percent() const
{
    return static_cast<int>(
        std::min((frames_.done() + written_) * 100 / (3 * frames_.total()), std::size_t{99}));
}

}
