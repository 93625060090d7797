#include "host/commands/flash/flash_environment.hpp"

#include "host/link/hid_pipe.hpp"
#include "host/program/interruption.hpp"

#include <thread>

namespace kfast {
namespace {

class HostFlashEnvironment final : public FlashEnvironment {
public:
    std::vector<BootBoard> boards_in_boot_loader() override { return kfast::boards_in_boot_loader(); }
    std::unique_ptr<BootLoader> open_boot_loader(const BootBoard& board) override
    {
        return kfast::open_boot_loader(board);
    }

    std::vector<DeviceAddress> attached_devices() override { return kfast::attached_devices(); }
    RemoteDevice open_device(const DeviceAddress& address, Milliseconds last_patience) override
    {
        return kfast::open_device(address, last_patience);
    }

    std::vector<Uf2Drive> uf2_drives() override { return kfast::uf2_drives(); }
    Uf2Drive uf2_drive_at(const std::string& folder) override { return kfast::uf2_drive_at(folder); }
    void copy_to_drive(const Uf2Drive& drive, const FlashImage& image,
                       const FlashProgressCallback& on_progress) override
    {
        kfast::copy_to_drive(drive, image, on_progress);
    }

    void enter_boot_loader(const BootLines& lines) override { kfast::enter_boot_loader(lines); }

    Milliseconds now() const override { return steady_milliseconds(); }
    void wait(Milliseconds time) override
    {
        heed_interruption();
        std::this_thread::sleep_for(time); // short ones: a signal may come before it begins
        heed_interruption();
    }
};

}

std::unique_ptr<FlashEnvironment> host_flash_environment()
{
    return std::make_unique<HostFlashEnvironment>();
}

}
