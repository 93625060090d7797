#pragma once

#include "firmware/link/message.hpp"
#include "host/commands/devices/device_options.hpp"
#include "host/link/remote_device.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace kfast {

/// "built-in", "slot" or "RAM"
std::string home_text(link::Home home);
/// "slot 2", "the built-in scene" or "the scene in RAM"
std::string place_text(link::Home home, std::uint8_t slot);
/// "slot 2, frame 12.5 of 60, paused"
std::string playing_text(const link::Playing& playing);
/// Null if nothing plays.
nlohmann::ordered_json playing_json(const link::Playing& playing);
/// Whether the device's laser may shine; null if it has none.
nlohmann::ordered_json armed_json(const link::Playing& playing);

/// Prints what each device plays now, in the form that the options choose.
void print_playing(std::span<RemoteDevice> devices, const DeviceOptions& options);

}
