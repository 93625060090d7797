#include "host/commands/devices/sending.hpp"

#include "host/commands/text/progress.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/scene_upload.hpp"
#include "host/program/failure.hpp"

#include <cstdint>
#include <numeric>
#include <utility>

namespace kfast {

ProgressBar::ProgressBar(std::size_t bytes, std::size_t devices, Shown shown, std::string what)
    : done_(devices),
      total_{bytes * devices},
      is_shown_{shown == Shown::on_a_terminal && line_.is_seen()},
      begin_{Clock::now()},
      drawn_{begin_ - between_drawings},
      what_{std::move(what)}
{
}

ByteProgressCallback ProgressBar::of_device(std::size_t index)
{
    return [this, index](std::size_t bytes) { report(index, bytes); };
}

void ProgressBar::report(std::size_t index, std::size_t bytes)
{
    if (!is_shown_)
        return;
    const std::lock_guard lock{mutex_};
    done_[index] = bytes;
    const std::size_t done = std::accumulate(done_.begin(), done_.end(), std::size_t{0});
    if (done == total_ || Clock::now() - drawn_ >= between_drawings)
        draw(done);
}

void ProgressBar::draw(std::size_t done)
{
    drawn_ = Clock::now();
    line_.show(what_ + progress_text(done, total_, drawn_ - begin_));
}

namespace {

/// Lets what the scene replaced play again.
void take_back(RemoteDevice& device, std::uint8_t tag)
{
    device.session().take_leave(link::report_of(link::Cancel{}, tag));
}

}

SentScene::SentScene(const SceneFile& scene, std::span<RemoteDevice> devices, const DeviceOptions& options)
    : devices_{devices}, tags_(devices.size())
{
    const link::Begin begin = begin_in_ram(scene.bytes);
    try {
        ProgressBar bar{scene.bytes.size(), devices.size(), shown_progress(options)};
        on_each(devices, [&](RemoteDevice& device, std::size_t index) {
            tags_[index] = upload_scene(device.session(), begin, scene.bytes, bar.of_device(index));
        });
    } catch (...) {
        for (std::size_t index = 0; index < devices.size(); ++index)
            if (tags_[index])
                take_back(devices[index], *tags_[index]);
        throw;
    }
}

void SentScene::play(std::size_t index, const link::Name& clip) const
{
    RemoteDevice& device = devices_[index];
    try {
        device.session().order(link::Play{.home = link::Home::ram, .clip = clip}, patience_to_begin);
    } catch (...) {
        take_back(device, *tags_[index]);
        throw;
    }
}

}
