#pragma once

#include "firmware/link/restarts.hpp"
#include "firmware/run/board.hpp"
#include "firmware/settings/board_rules.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// The lines of the log (log.hpp):
///
///     KFAST <version> pico <controller> <width>x<height>      or: beam <points a second>
///     RESTARTED <times in a row>                              by the watchdog, if it was
///     SCENE <bytes> <CRC-32>
///     EVENT <name>                                            when it is passed, before the frame
///     F <time in 1/1024 frame> <frames skipped so far>        when it has arrived
///     ERROR <what is wrong>
///     FAULT <exception> at <address>                          from start.cpp, before the watchdog resets
namespace kfast::pico::report {

void begun(const BoardSettings& settings);
void restarted(const link::Restarts& restarts);
void scene_started(std::span<const std::byte> scene);
void event_passed(std::string_view name);
void frame_shown(FrameReport frame);
void fault(Error error);
/// Stored settings that this image, which is for `bus`, cannot work with.
void other_bus(BusKind settings, BusKind bus);
void mistake(SettingsMistake mistake);
/// No display on I²C acknowledges what is sent.
void no_display(std::uint8_t i2c_address);

}
