#include "host/commands/sent_scene.hpp"

#include "host/commands/progress_bar.hpp"
#include "host/link/on_each.hpp"
#include "host/link/scene_upload.hpp"

namespace kfast {

void send_into_ram(const SceneFile& scene, std::span<RemoteDevice> devices, const DeviceOptions& options)
{
    const link::Begin begin = begin_in_ram(scene.bytes);
    ProgressBar bar{scene.bytes.size(), devices.size(), shown_progress(options)};
    on_each(devices, [&](RemoteDevice& device, std::size_t index) {
        upload_scene(device.session(), begin, scene.bytes, bar.of_device(index));
    });
}

}
