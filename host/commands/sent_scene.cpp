#include "host/commands/sent_scene.hpp"

#include "host/commands/progress_bar.hpp"
#include "host/failure.hpp"
#include "host/link/on_each.hpp"
#include "host/link/scene_upload.hpp"

#include <atomic>
#include <deque>

namespace kfast {
namespace {

/// Otherwise nothing might play there.
void return_to_start(RemoteDevice& device)
{
    Session& session = device.session();
    session.take_leave(link::report_of(link::Play{.home = link::Home::start}, session.new_tag()));
}

}

void send_into_ram(const SceneFile& scene, std::span<RemoteDevice> devices, const DeviceOptions& options)
{
    const link::Begin begin = begin_in_ram(scene.bytes);
    std::deque<std::atomic<bool>> have_it(devices.size());
    try {
        ProgressBar bar{scene.bytes.size(), devices.size(), shown_progress(options)};
        on_each(devices, [&](RemoteDevice& device, std::size_t index) {
            upload_scene(device.session(), begin, scene.bytes, bar.of_device(index));
            have_it[index] = true;
        });
    } catch (const Failure&) {
        for (std::size_t index = 0; index < devices.size(); ++index)
            if (have_it[index])
                return_to_start(devices[index]);
        throw;
    }
}

void play_from_ram(RemoteDevice& device, const link::Name& clip)
{
    try {
        device.session().order(link::Play{.home = link::Home::ram, .clip = clip}, patience_to_begin);
    } catch (const Failure&) {
        return_to_start(device);
        throw;
    }
}

}
