#pragma once

#include "host/commands/flash/flash_environment.hpp"

#include <optional>
#include <string>
#include <variant>

namespace kfast {

/// Which board is meant, as far as a person has said it.
struct PlaceWish {
    std::string port;   ///< of a board in its boot loader: "1-2.3"
    std::string serial; ///< of a board that runs KFAST
    std::string drive;  ///< the folder where a drive is mounted
};

/// Where flash can be written: a board in its boot loader, one that has to enter it first, or a drive.
using FlashPlace = std::variant<BootBoard, DeviceAddress, Uf2Drive>;

/// What the wish names; else the only board in its boot loader, else the only one that runs KFAST, else the
/// only drive. Touches nothing.
///
/// Throws Failure: with no_device if there is none, or not that one; with wrong_usage if there are several;
/// with wrong_chip if it is no RP2040.
FlashPlace flash_place(FlashEnvironment& environment, const PlaceWish& wish);

/// The board in its boot loader at that port, or the only one if it is empty; nothing if there is none.
/// Throws as flash_place() for several boards and for another chip.
std::optional<BootBoard> boot_board(FlashEnvironment& environment, const std::string& port);

/// The drive of an RP2040, if exactly one is mounted.
std::optional<Uf2Drive> only_drive(FlashEnvironment& environment);

/// Throws Failure with no_device, which tells how a board is found.
[[noreturn]] void refuse_no_board();

/// How somebody lets a Pico enter its boot loader by hand.
inline constexpr const char* boot_loader_by_hand = "hold BOOTSEL while you plug the Pico in, and ask again";

}
