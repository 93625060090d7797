#pragma once

#include "host/commands/device_options.hpp"
#include "host/link/remote_device.hpp"
#include "host/scene_file.hpp"

#include <span>

namespace kfast {

/// Sends a scene into the RAM of all devices, with a progress bar if the options allow it. It does not play
/// yet. Throws what upload_scene() throws.
void send_into_ram(const SceneFile& scene, std::span<RemoteDevice> devices, const DeviceOptions& options);

}
