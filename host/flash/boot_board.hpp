#pragma once

#include "host/flash/boot_loader.hpp"
#include "host/program/failure.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace kfast {

/// The chips whose boot loaders are known.
enum class BootChip : std::uint8_t { rp2040, rp2350 };

/// A board whose boot loader waits at USB.
struct BootBoard {
    BootChip chip = BootChip::rp2040;
    /// Where it is plugged in, as Linux calls it: "1-2.3". The only thing that tells one from another: all
    /// RP2040 have the same serial number there.
    std::string port;

    friend bool operator==(const BootBoard&, const BootBoard&) = default;
};

/// Those that are plugged in, in the order of their ports. Needs no permission.
std::vector<BootBoard> boards_in_boot_loader();

/// The boot loader was started without PICOBOOT: it is a drive, and nothing else.
class NoPicoboot : public Failure {
public:
    NoPicoboot()
        : Failure{
              "the boot loader was started without PICOBOOT: plug the board in anew with BOOTSEL held down",
              ExitStatus::refused}
    {
    }
};

/// Throws NoPicoboot, and Failure with no_permission, no_device (it is gone), wrong_chip, refused (somebody
/// else has it), and as BootLoader.
std::unique_ptr<BootLoader> open_boot_loader(const BootBoard& board);

}
