#include "host/commands/flash/flash_environment.hpp"

#include "host/link/hid_pipe.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <optional>
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

namespace {

constexpr const char* rp2040_drive = "RPI-RP2";

template <class T, class Name>
std::string list_of(const std::vector<T>& all, Name name)
{
    std::string list;
    for (const T& one : all)
        list += (list.empty() ? "" : ", ") + visible(name(one));
    return list;
}

std::string ports_of(const std::vector<BootBoard>& boards)
{
    return list_of(boards, [](const BootBoard& board) { return board.port; });
}

std::string serials_of(const std::vector<DeviceAddress>& devices)
{
    return list_of(devices, [](const DeviceAddress& device) { return name_of(device); });
}

std::string folders_of(const std::vector<Uf2Drive>& drives)
{
    return list_of(drives, [](const Uf2Drive& drive) { return drive.folder.string(); });
}

[[noreturn]] void refuse_chip(const BootBoard& board)
{
    throw Failure{
        "the board at " + board.port +
            " has an RP2350, as the Pico 2 has: there is firmware for the RP2040 alone, that of the "
            "Pico, Pico H and Pico W",
        ExitStatus::wrong_chip};
}

[[noreturn]] void refuse_several(const std::string& state, const std::string& option, const std::string& list)
{
    throw Failure{"several boards " + state + ": choose with " + option + ": " + list,
                  ExitStatus::wrong_usage};
}

std::vector<BootBoard> rp2040s_of(std::vector<BootBoard> boards)
{
    std::erase_if(boards, [](const BootBoard& board) { return board.chip != BootChip::rp2040; });
    return boards;
}

/// The board at the port.
std::optional<BootBoard> board_at(const std::string& port, const std::vector<BootBoard>& boards)
{
    const auto found = std::ranges::find(boards, port, &BootBoard::port);
    if (found == boards.end())
        return std::nullopt;
    if (found->chip != BootChip::rp2040)
        refuse_chip(*found);
    return *found;
}

BootBoard required_board_at(const std::string& port, const std::vector<BootBoard>& boards)
{
    if (const auto board = board_at(port, boards))
        return *board;
    throw Failure{"there is no board in its boot loader at " + in_quotes(port) + ": " +
                      (boards.empty() ? boot_loader_by_hand : "there are: " + ports_of(boards)),
                  ExitStatus::no_device};
}

DeviceAddress device_called(const std::string& serial, const std::vector<DeviceAddress>& devices)
{
    const auto found = std::ranges::find(devices, serial, &DeviceAddress::serial);
    if (found != devices.end())
        return *found;
    throw Failure{"no board that runs KFAST has the serial number " + in_quotes(serial) + ": " +
                      (devices.empty() ? "none is there; in the boot loader, boards are known by their --port"
                                       : "there are: " + serials_of(devices)),
                  ExitStatus::no_device};
}

std::optional<BootBoard> only_board(const std::vector<BootBoard>& boards)
{
    const std::vector<BootBoard> usable = rp2040s_of(boards);
    if (usable.size() > 1)
        refuse_several("are in their boot loaders", "--port", ports_of(usable));
    if (usable.empty() && !boards.empty())
        refuse_chip(boards.front());
    return usable.empty() ? std::nullopt : std::optional{usable.front()};
}

std::vector<Uf2Drive> rp2040_drives(FlashEnvironment& environment)
{
    std::vector<Uf2Drive> drives = environment.uf2_drives();
    std::erase_if(drives, [](const Uf2Drive& drive) { return drive.board != rp2040_drive; });
    return drives;
}

/// The place if none was chosen.
FlashPlace only_place(FlashEnvironment& environment)
{
    if (const auto board = only_board(environment.boards_in_boot_loader()))
        return *board;
    const auto devices = environment.attached_devices();
    if (devices.size() > 1)
        refuse_several("run KFAST", "--device", serials_of(devices));
    if (!devices.empty())
        return devices.front();
    const auto drives = rp2040_drives(environment);
    if (drives.size() > 1)
        refuse_several("are mounted as drives", "--drive", folders_of(drives));
    if (drives.empty())
        refuse_no_board();
    return drives.front();
}

}

FlashPlace flash_place(FlashEnvironment& environment, const PlaceWish& wish)
{
    if (!wish.drive.empty())
        return environment.uf2_drive_at(wish.drive);
    if (!wish.port.empty())
        return required_board_at(wish.port, environment.boards_in_boot_loader());
    if (!wish.serial.empty())
        return device_called(wish.serial, environment.attached_devices());
    return only_place(environment);
}

std::optional<BootBoard> boot_board(FlashEnvironment& environment, const std::string& port)
{
    const auto boards = environment.boards_in_boot_loader();
    return port.empty() ? only_board(boards) : board_at(port, boards);
}

std::optional<Uf2Drive> only_drive(FlashEnvironment& environment)
{
    const auto drives = rp2040_drives(environment);
    return drives.size() == 1 ? std::optional{drives.front()} : std::nullopt;
}

void refuse_no_board()
{
    throw Failure{std::string{"there is no board: "} + boot_loader_by_hand +
                      "; one that runs KFAST already is found as it is",
                  ExitStatus::no_device};
}

}
