#include "host/commands/devices/sent_scene.hpp"

#include "host/commands/devices/progress_bar.hpp"
#include "host/link/on_each.hpp"
#include "host/link/scene_upload.hpp"
#include "host/program/failure.hpp"

#include <cstdint>

namespace kfast {
namespace {

/// What gave way to the scene plays again.
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
    } catch (const Failure&) {
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
    } catch (const Failure&) {
        take_back(device, *tags_[index]);
        throw;
    }
}

}
