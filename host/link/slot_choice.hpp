#pragma once

#include "firmware/link/message.hpp"
#include "host/link/remote_device.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// What all slots of a device hold.
std::vector<link::SlotContents> slots_of(RemoteDevice& device);

/// Where a scene of that name goes: where one of the same name is, else the first empty slot. Throws Failure
/// with no_room if there is none.
std::uint8_t slot_for(std::string_view name, std::span<const link::SlotContents> slots);

/// The longest beginning of the name that a device can keep, in whole characters.
std::string_view stored_name(std::string_view name);

}
