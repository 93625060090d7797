#pragma once

#include "host/flash/boot_board.hpp"
#include "host/flash/uf2_drive.hpp"
#include "host/gpio/boot_entry.hpp"
#include "host/link/device_address.hpp"
#include "host/link/remote_device.hpp"

#include <memory>
#include <string>
#include <vector>

namespace kfast {

/// All boards within reach, in whatever state they are, and the time that passes meanwhile. Tests have one of
/// their own, hence virtual.
///
/// Members throw what the functions throw whose names they have.
class FlashEnvironment {
public:
    FlashEnvironment() = default;
    virtual ~FlashEnvironment() = default;
    FlashEnvironment(const FlashEnvironment&) = delete;
    FlashEnvironment& operator=(const FlashEnvironment&) = delete;

    virtual std::vector<BootBoard> boards_in_boot_loader() = 0;
    virtual std::unique_ptr<BootLoader> open_boot_loader(const BootBoard& board) = 0;

    /// Those that run KFAST.
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

/// That of this computer: USB, mounted drives and GPIO lines.
std::unique_ptr<FlashEnvironment> host_flash_environment();

}
