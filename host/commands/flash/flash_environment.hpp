#pragma once

#include "host/flash/boot_board.hpp"
#include "host/flash/uf2_drive.hpp"
#include "host/gpio/boot_entry.hpp"
#include "host/link/device_address.hpp"
#include "host/link/remote_device.hpp"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace kfast {

/// All boards within reach, in whatever state they are, and the time that passes meanwhile. Tests have one of
/// their own, hence virtual.
///
/// Members throw what the functions of the same names throw.
class FlashEnvironment {
public:
    FlashEnvironment() = default;
    virtual ~FlashEnvironment() = default;
    FlashEnvironment(const FlashEnvironment&) = delete;
    FlashEnvironment& operator=(const FlashEnvironment&) = delete;

    virtual std::vector<BootBoard> boards_in_boot_loader() = 0;
    virtual std::unique_ptr<BootLoader> open_boot_loader(const BootBoard& board) = 0;

    /// The devices that run KFAST.
    virtual std::vector<DeviceAddress> attached_devices() = 0;
    virtual RemoteDevice open_device(const DeviceAddress& address, Milliseconds last_patience) = 0;

    virtual std::vector<Uf2Drive> uf2_drives() = 0;
    virtual Uf2Drive uf2_drive_at(const std::string& folder) = 0;
    virtual void copy_to_drive(const Uf2Drive& drive, const FlashImage& image,
                               const FlashProgressCallback& on_progress) = 0;

    virtual void enter_boot_loader(const BootLines& lines) = 0;

    /// The time since some moment. It never goes back.
    virtual Milliseconds now() const = 0;
    /// Throws Interrupted.
    virtual void wait(Milliseconds time) = 0;
};

/// The environment of this computer: USB, mounted drives and GPIO lines.
std::unique_ptr<FlashEnvironment> host_flash_environment();

/// Which board is meant, as far as the user has chosen it.
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

/// Throws Failure with no_device, which says how a board is found.
[[noreturn]] void refuse_no_board();

/// How to let a Pico enter its boot loader by hand.
inline constexpr const char* boot_loader_by_hand = "hold BOOTSEL while you plug the Pico in, and ask again";

}
