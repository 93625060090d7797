#pragma once

#include "firmware/link/message_kind.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/compile/scene_file.hpp"
#include "host/link/remote_device.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kfast {

/// A scene that has come into the RAM of all devices. What played before may have given way to it.
class SentScene {
public:
    /// Sends it, with a progress bar if the options allow it. Throws what upload_scene() throws; then it is
    /// taken back from the devices that have it already, and they play what they played before.
    SentScene(const SceneFile& scene, std::span<RemoteDevice> devices, const DeviceOptions& options);

    /// Plays it on a device, or only one of its clips. Throws what Session throws, and Refusal; then it is
    /// taken back.
    void play(std::size_t device, const link::Name& clip) const;

private:
    std::span<RemoteDevice> devices_;
    std::vector<std::optional<std::uint8_t>> tags_; ///< of the uploads
};

}
