#pragma once

#include "host/commands/device_options.hpp"
#include "host/link/remote_device.hpp"
#include "host/scene_file.hpp"

#include <span>

namespace kfast {

/// Sends a scene into the RAM of all devices, with a progress bar if the options allow it. It does not play
/// yet, and what played before may have given way to it. Throws what upload_scene() throws; then devices that
/// have the scene already are returned to that of their start.
void send_into_ram(const SceneFile& scene, std::span<RemoteDevice> devices, const DeviceOptions& options);

/// Plays it, or only one of its clips. Throws what Session throws, and Refusal; a device is returned to the
/// scene of its start even then.
void play_from_ram(RemoteDevice& device, const link::Name& clip);

}
