#pragma once

#include "firmware/link/message.hpp"
#include "firmware/link/upload_message.hpp"
#include "host/link/remote_device.hpp"
#include "host/link/session.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// The contents of all slots of a device.
std::vector<link::SlotContents> slots_of(RemoteDevice& device);

/// The slot for a scene of that name: where one of the same name is, or the first empty one. Throws Failure
/// with no_room if there is none.
std::uint8_t slot_for(std::string_view name, std::span<const link::SlotContents> slots);

/// The longest beginning of the name that a device can keep, in whole characters.
std::string_view stored_name(std::string_view name);

/// Called with how many bytes of the scene the device has; it may become fewer when an upload begins anew.
using ByteProgressCallback = std::function<void(std::size_t bytes)>;

/// The message that begins the upload of a scene. `name` finds room.
link::Begin begin_in_slot(std::uint8_t slot, std::string_view name, std::span<const std::byte> scene);
link::Begin begin_in_ram(std::span<const std::byte> scene);

/// Brings a scene to a device by the rules of docs/link.md: keeps the window full, goes back where blocks
/// are missing, begins anew when the device has dropped the upload or found it damaged. If it is interrupted,
/// it asks the device to drop the upload. `begin` is for these bytes.
///
/// Returns the tag of the upload, by which it can be cancelled. Throws what Session throws, and Refusal.
std::uint8_t upload_scene(Session& session, const link::Begin& begin, std::span<const std::byte> scene,
                          const ByteProgressCallback& on_progress);

}
