#include "host/commands/flash/flash_report.hpp"

#include "host/commands/devices/playing_text.hpp"
#include "host/commands/flash/flash_environment.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/flash/flash_image.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"

#include <iostream>
#include <string>
#include <unistd.h>

namespace kfast {

namespace {

std::string word_of(FlashPhase phase)
{
    switch (phase) {
    case FlashPhase::comparing:
        return "comparing";
    case FlashPhase::writing:
        return "writing";
    case FlashPhase::verifying:
        return "verifying";
    }
    return {};
}

}

void FlashProgress::report(FlashPhase phase, std::size_t done, std::size_t total)
{
    if (shown_ == ProgressBar::Shown::no)
        return;
    if (phase != phase_)
        begin(phase, total);
    if (bar_)
        bar_->of_device(0)(done * FlashImage::sector_bytes);
}

void FlashProgress::begin(FlashPhase phase, std::size_t total)
{
    constexpr std::size_t width = std::string_view{"verifying "}.size();
    phase_ = phase;
    bar_.reset();
    std::string what = word_of(phase);
    if (::isatty(STDERR_FILENO) == 1)
        bar_.emplace(total * FlashImage::sector_bytes, 1, shown_, what.append(width - what.size(), ' '));
    else
        std::cerr << what << ' ' << counted(total, "sector") << '\n';
}

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

namespace {

/// A line for each run of neighbours: "  0x10040000, 2 sectors, 8192 bytes".
std::string sector_lines(const std::vector<std::uint32_t>& addresses)
{
    std::string lines;
    for (std::size_t begin = 0, end = 0; begin < addresses.size(); begin = end) {
        for (end = begin + 1; end < addresses.size(); ++end)
            if (addresses[end] != addresses[end - 1] + FlashImage::sector_bytes)
                break;
        lines += "  " + hex_text(addresses[begin]) + ", " + counted(end - begin, "sector") + ", " +
                 std::to_string((end - begin) * FlashImage::sector_bytes) + " bytes\n";
    }
    return lines;
}

std::string place_words(const FlashOutcome& outcome)
{
    if (!outcome.drive.empty())
        return visible(outcome.drive);
    return outcome.port.empty() ? "" : "the board at " + visible(outcome.port);
}

std::string holds_all(const FlashOutcome& outcome)
{
    return place_words(outcome) + " holds all of it already\n";
}

std::string dry_text(const FlashOutcome& outcome)
{
    if (outcome.differing && outcome.differing->empty())
        return holds_all(outcome);
    if (outcome.differing)
        return "to be written to " + place_words(outcome) +
               ", as flash holds something else there: " + counted(outcome.differing->size(), "sector") +
               '\n' + sector_lines(*outcome.differing);
    return "to be written" + (outcome.drive.empty() ? "" : " to " + place_words(outcome)) +
           ": those that differ from what flash holds, which is not known\n" +
           sector_lines(outcome.addresses);
}

std::string written_text(const FlashOutcome& outcome)
{
    if (!outcome.drive.empty())
        return "copied to " + place_words(outcome) + ", which cannot be verified\n";
    if (outcome.written == 0)
        return holds_all(outcome);
    return counted(outcome.written, "sector") + " written to " + place_words(outcome) + " and verified\n";
}

}

std::string flash_text(const FlashOutcome& outcome, FlashPurpose purpose)
{
    const std::string contents = outcome.contents + ": " + counted(outcome.addresses.size(), "sector") + '\n';
    switch (purpose) {
    case FlashPurpose::write:
        return contents + written_text(outcome);
    case FlashPurpose::dry_run:
        return contents + dry_text(outcome);
    case FlashPurpose::verify_only:
        return contents + place_words(outcome) + " holds all of it\n";
    }
    return {};
}

std::string player_text(const PlayerOutcome& player)
{
    std::string text;
    if (player.left_slot)
        text = player.name + ": slot " + std::to_string(int{*player.left_slot}) +
               " was chosen to play; the built-in scene is chosen now\n";
    return text + player.name + ": plays " + playing_text(player.playing) + '\n';
}

Json flash_json(const FlashOutcome& outcome, const std::optional<PlayerOutcome>& player)
{
    const auto or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
    return {
        {"board", "pico"},
        {"contents", outcome.contents},
        {"port", or_null(outcome.port)},
        {"drive", or_null(outcome.drive)},
        {"sectors", outcome.addresses.size()},
        {"differing", outcome.differing ? Json(*outcome.differing) : Json()},
        {"written", outcome.written},
        {"verified", outcome.verified},
        {"restarted", outcome.restarted},
        {"serial", player ? Json(player->name) : or_null(outcome.serial)},
        {"left_slot", player && player->left_slot ? Json(*player->left_slot) : Json()},
        {"plays", player ? playing_json(player->playing) : Json()},
    };
}

}
