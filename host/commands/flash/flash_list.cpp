#include "host/commands/flash/flash_list.hpp"

#include "host/commands/flash/flash_place.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/program/failure.hpp"
#include "host/text/glyph.hpp"

#include <iostream>
#include <string>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

struct Found {
    std::vector<BootBoard> boards;
    std::vector<DeviceAddress> devices;
    std::vector<Uf2Drive> drives;

    bool is_nothing() const { return boards.empty() && devices.empty() && drives.empty(); }
};

std::string chip_name(BootChip chip) { return chip == BootChip::rp2040 ? "RP2040" : "RP2350"; }

Json json_of(const Found& found)
{
    Json json{{"boot_loaders", Json::array()}, {"devices", Json::array()}, {"drives", Json::array()}};
    for (const BootBoard& board : found.boards)
        json["boot_loaders"].push_back({{"port", board.port}, {"chip", chip_name(board.chip)}});
    for (const DeviceAddress& device : found.devices)
        json["devices"].push_back({{"serial", device.serial}});
    for (const Uf2Drive& drive : found.drives)
        json["drives"].push_back({{"folder", drive.folder.string()}, {"board", drive.board}});
    return json;
}

std::string text_of(const Found& found)
{
    std::string text;
    for (const BootBoard& board : found.boards)
        text += "in its boot loader, " + chip_name(board.chip) + ": --port " + visible(board.port) + '\n';
    for (const DeviceAddress& device : found.devices)
        text += "runs KFAST: --device " + visible(name_of(device)) + '\n';
    for (const Uf2Drive& drive : found.drives)
        text += "drive of a boot loader, " + visible(drive.board) + ": --drive " +
                visible(drive.folder.string()) + '\n';
    return text;
}

}

void print_flash_list(FlashEnvironment& environment, ListForm form)
{
    const Found found{environment.boards_in_boot_loader(), environment.attached_devices(),
                      environment.uf2_drives()};
    std::cout << (form == ListForm::json ? json_text(json_of(found)) : text_of(found));
    std::cout.flush(); // before the reason
    if (found.is_nothing())
        refuse_no_board();
}

}
