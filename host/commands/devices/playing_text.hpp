#pragma once

#include "firmware/link/message.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/link/remote_device.hpp"

#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace kfast {

/// "slot 2, frame 12.5 of 60, paused"
std::string playing_text(const link::Playing& playing);
/// Null if nothing plays.
nlohmann::ordered_json playing_json(const link::Playing& playing);
/// Whether the device's laser may shine; null if it has none.
nlohmann::ordered_json armed_json(const link::Playing& playing);

/// Prints what each device plays now, in the form that the options choose.
void print_playing(std::span<RemoteDevice> devices, const DeviceOptions& options);

}
