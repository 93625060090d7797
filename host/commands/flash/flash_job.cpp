#include "host/commands/flash/flash_job.hpp"

#include "firmware/settings/board_record.hpp"
#include "host/config/mistake_text.hpp"
#include "host/config/pico_flash.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <utility>

namespace kfast {
namespace {

constexpr Milliseconds between_looks{100};
/// udev sets permissions, and desktops mount drives, some time after a board is seen.
constexpr Milliseconds settling{3000};
/// The time until USB has noticed that a board has restarted.
constexpr Milliseconds noticing{1000};
constexpr Milliseconds beginning_to_play{2000};

std::string seconds_text(Milliseconds time)
{
    std::ostringstream text;
    text << static_cast<double>(time.count()) / 1000 << " seconds";
    return text.str();
}

std::vector<std::byte> sector_at(BootLoader& boot_loader, std::uint32_t address)
{
    std::vector<std::byte> bytes(FlashImage::sector_bytes);
    boot_loader.read(address, bytes);
    return bytes;
}

FoundOnBoard found_on(BootLoader& boot_loader)
{
    FoundOnBoard found{read_board_record(sector_at(boot_loader, pico_flash::settings)),
                       sector_at(boot_loader, pico_flash::begin)};
    if (found.settings && !config::mistakes(*found.settings).empty())
        found.settings.reset();
    return found;
}

Failure with_advice(const Failure& failure, const std::string& advice)
{
    return Failure{failure.what() + ("\n" + advice), failure.status()};
}

constexpr const char* half_flashed = "The board does not start what was not written to the end. Plug it in "
                                     "again if it was unplugged; the same command once more repairs it";
constexpr const char* lost_settings =
    ". If it says that no settings can be read, they are lost: name the display with --panel then, and all "
    "pins that are elsewhere";

std::vector<std::uint32_t> addresses_of(const FlashImage& image)
{
    std::vector<std::uint32_t> addresses;
    for (const FlashImage::Sector& sector : image.sectors())
        addresses.push_back(sector.address);
    return addresses;
}

/// In the order of addresses, the first one among them if there are any: it is written anew.
std::size_t written_sectors(const std::vector<std::size_t>& differing)
{
    return differing.size() + (differing.empty() || differing.front() == 0 ? 0 : 1);
}

}

FlashJob::FlashJob(FlashEnvironment& environment, const FlashPlan& plan, const FlashOrder& order,
                   const FlashProgressCallback& on_progress)
    : environment_{environment}, plan_{plan}, order_{order}, on_progress_{on_progress}
{
}

FlashOutcome FlashJob::run()
{
    const bool is_dry = order_.purpose == FlashPurpose::dry_run;
    if (order_.lines)
        return is_dry ? untouched() : run_on(entered_by_lines());
    try {
        return std::visit([this](const auto& place) { return run_on(place); },
                          flash_place(environment_, order_.place));
    } catch (const Failure& failure) {
        if (!is_dry || failure.status() != ExitStatus::no_device)
            throw;
    }
    return untouched();
}

BootBoard FlashJob::entered_by_lines()
{
    environment_.enter_boot_loader(*order_.lines);
    has_just_come_ = true;
    environment_.wait(noticing);
    for (const Milliseconds end = environment_.now() + order_.last_patience; environment_.now() < end;
         environment_.wait(between_looks)) {
        if (const auto board = boot_board(environment_, order_.place.port))
            return *board;
    }
    throw Failure{"no boot loader has been seen for " + seconds_text(order_.last_patience) +
                      " after reset and boot line: is " + visible(order_.lines->reset) + " wired to RUN, " +
                      visible(order_.lines->boot) +
                      " through a resistor to BOOTSEL, and the board to USB (docs/flash.md)?",
                  ExitStatus::timed_out};
}

FlashOutcome FlashJob::untouched()
{
    const FlashContents contents = plan_.contents_for(std::nullopt);
    return {.contents = contents.words, .addresses = addresses_of(FlashImage{contents.regions})};
}

FlashOutcome FlashJob::run_on(const DeviceAddress& device)
{
    if (order_.purpose == FlashPurpose::dry_run)
        return untouched();
    const std::vector<BootBoard> before = environment_.boards_in_boot_loader();
    ask_to_leave(device);
    has_just_come_ = true;
    asked_ = device.serial;
    return run_on(await_boot_loader(before));
}

void FlashJob::ask_to_leave(const DeviceAddress& address)
{
    RemoteDevice device = player_at(address);
    const auto names = device.session().ask<link::Names>(link::AskNames{});
    plan_.require_room_with(names.panel.view(), device.capabilities().panel);
    device.session().order(link::EnterBootLoader{});
}

RemoteDevice FlashJob::player_at(const DeviceAddress& address)
{
    try {
        return environment_.open_device(address, order_.last_patience);
    } catch (const Interrupted&) {
        throw;
    } catch (const Failure& failure) {
        throw with_advice(failure,
                          std::string{"Or let it enter its boot loader by hand: "} + boot_loader_by_hand);
    }
}

BootBoard FlashJob::await_boot_loader(const std::vector<BootBoard>& before)
{
    const auto was_there = [&](const BootBoard& board) {
        return std::ranges::find(before, board.port, &BootBoard::port) != before.end();
    };
    for (const Milliseconds end = environment_.now() + order_.last_patience; environment_.now() < end;
         environment_.wait(between_looks)) {
        const auto boards = environment_.boards_in_boot_loader();
        const auto fresh = std::ranges::find_if_not(boards, was_there);
        if (fresh != boards.end())
            return *fresh;
    }
    throw Failure{"the board was asked to enter its boot loader, which has not been seen for " +
                      seconds_text(order_.last_patience) + ": unplug it, " + boot_loader_by_hand,
                  ExitStatus::timed_out};
}

FlashOutcome FlashJob::run_on(const BootBoard& board)
{
    std::unique_ptr<BootLoader> boot_loader;
    try {
        boot_loader = opened(board);
    } catch (const Failure& failure) {
        const auto drive = drive_instead(failure);
        if (!drive)
            throw;
        std::cerr << "kfast: warning: " << failure.what() << "\nThe drive of the board is used instead.\n";
        return run_on(*drive);
    }
    port_ = board.port;
    FlashOutcome outcome = run_with(*boot_loader);
    outcome.serial = asked_;
    outcome.port = port_;
    return outcome;
}

/// The drive of the only board, which cannot be opened.
std::optional<Uf2Drive> FlashJob::drive_instead(const Failure& failure)
{
    const bool is_shut =
        failure.status() == ExitStatus::no_permission || dynamic_cast<const NoPicoboot*>(&failure) != nullptr;
    if (!is_shut || order_.purpose == FlashPurpose::verify_only ||
        environment_.boards_in_boot_loader().size() != 1)
        return std::nullopt;
    auto drive = only_drive(environment_);
    if (drive && plan_.depends_on_board())
        throw with_advice(failure, "Its drive at " + visible(drive->folder.string()) +
                                       " does not tell which display it has: with --panel or --config, the "
                                       "drive is used instead");
    return drive;
}

/// A boot loader that has just appeared may lack a permission, or not be set up yet.
std::unique_ptr<BootLoader> FlashJob::opened(const BootBoard& board)
{
    const Milliseconds end = environment_.now() + (has_just_come_ ? settling : Milliseconds{0});
    for (;; environment_.wait(between_looks)) {
        try {
            return environment_.open_boot_loader(board);
        } catch (const Failure& failure) {
            const bool stays =
                failure.status() == ExitStatus::wrong_chip || failure.status() == ExitStatus::timed_out;
            if (stays || environment_.now() >= end)
                throw;
        }
    }
}

FlashOutcome FlashJob::run_with(BootLoader& boot_loader)
{
    try {
        const FlashContents contents = plan_.contents_for(found_on(boot_loader));
        const FlashImage image{contents.regions};
        FlashOutcome outcome{.contents = contents.words, .addresses = addresses_of(image)};
        if (order_.purpose == FlashPurpose::verify_only) {
            verify(boot_loader, image, on_progress_);
            outcome.differing.emplace();
            outcome.verified = true;
        } else {
            const auto differing = differing_sectors(boot_loader, image, on_progress_);
            outcome.differing.emplace();
            for (const std::size_t index : differing)
                outcome.differing->push_back(outcome.addresses[index]);
            if (order_.purpose == FlashPurpose::write)
                write(boot_loader, image, differing, outcome);
        }
        leave(boot_loader, outcome);
        return outcome;
    } catch (const Failure&) {
        if (!is_written_)
            let_play_again(boot_loader);
        throw;
    }
}

void FlashJob::write(BootLoader& boot_loader, const FlashImage& image,
                     const std::vector<std::size_t>& differing, FlashOutcome& outcome)
{
    is_written_ = !differing.empty();
    try {
        write_sectors(boot_loader, image, differing, on_progress_);
    } catch (const Failure& failure) {
        throw with_advice(failure,
                          std::string{half_flashed} + (plan_.changes_settings() ? lost_settings : ""));
    }
    outcome.written = written_sectors(differing);
    outcome.verified = true;
}

/// Boards that somebody has put into their boot loaders by hand stay there unless they are written to.
void FlashJob::leave(BootLoader& boot_loader, FlashOutcome& outcome)
{
    if (order_.purpose != FlashPurpose::write) {
        let_play_again(boot_loader);
        outcome.restarted = has_just_come_;
        return;
    }
    remember_devices();
    restart(boot_loader);
    outcome.restarted = true;
}

/// A boot loader stays for a moment after it has reported that it restarts. A search for boards must not find
/// it then.
void FlashJob::restart(BootLoader& boot_loader)
{
    boot_loader.restart();
    const auto is_there = [&] {
        const auto boards = environment_.boards_in_boot_loader();
        return std::ranges::find(boards, port_, &BootBoard::port) != boards.end();
    };
    for (const Milliseconds end = environment_.now() + noticing; environment_.now() < end && is_there();)
        environment_.wait(between_looks);
}

void FlashJob::let_play_again(BootLoader& boot_loader)
{
    if (!has_just_come_)
        return;
    try {
        restart(boot_loader);
    } catch (const Failure&) { // the failure before is the one to report
    }
}

FlashOutcome FlashJob::run_on(const Uf2Drive& drive)
{
    if (order_.purpose == FlashPurpose::verify_only)
        throw Failure{"a drive does not tell what lies in flash: --verify-only needs a board that may be "
                      "opened by USB",
                      ExitStatus::wrong_usage};
    const FlashContents contents = plan_.contents_for(std::nullopt);
    const FlashImage image{contents.regions};
    FlashOutcome outcome{.contents = contents.words,
                         .addresses = addresses_of(image),
                         .serial = asked_,
                         .drive = drive.folder.string()};
    if (order_.purpose == FlashPurpose::dry_run)
        return outcome;
    remember_devices();
    try {
        environment_.copy_to_drive(drive, image, on_progress_);
    } catch (const Failure& failure) {
        throw with_advice(failure, half_flashed);
    }
    outcome.written = outcome.addresses.size();
    outcome.restarted = true;
    return outcome;
}

void FlashJob::remember_devices()
{
    for (const DeviceAddress& device : environment_.attached_devices())
        devices_.insert(name_of(device));
}

bool FlashJob::is_new(const DeviceAddress& device) const
{
    return asked_.empty() ? !devices_.contains(name_of(device)) : device.serial == asked_;
}

PlayerOutcome FlashJob::await_player()
{
    Failure reason{"no player has come for " + seconds_text(order_.last_patience) +
                       ": its LED tells why (docs/config.md); a firmware that is not KFAST's has none, "
                       "--no-wait goes with it",
                   ExitStatus::timed_out};
    for (const Milliseconds end = environment_.now() + order_.last_patience; environment_.now() < end;
         environment_.wait(between_looks)) {
        for (const DeviceAddress& device : environment_.attached_devices()) {
            try {
                if (is_new(device))
                    return player_of(device);
            } catch (const Interrupted&) {
                throw;
            } catch (const Failure& failure) { // udev or the player may need some more time
                reason = failure;
            }
        }
    }
    throw Failure{std::string{"the board was flashed and has restarted, but: "} + reason.what(),
                  reason.status()};
}

PlayerOutcome FlashJob::player_of(const DeviceAddress& address)
{
    RemoteDevice device = environment_.open_device(address, order_.last_patience);
    PlayerOutcome outcome{device.name(), playing_on(device), std::nullopt};
    if (!plan_.has_scene())
        return outcome;
    if (outcome.playing.is_playing && outcome.playing.home == link::Home::slot) {
        outcome.left_slot = outcome.playing.slot;
        device.session().order(link::ChooseSlot{link::no_slot}, patience_with_flash);
        device.session().order(link::Play{.home = link::Home::built_in}, patience_to_begin);
        outcome.playing = playing_on(device);
    }
    return outcome;
}

/// A player that has begun a moment ago may answer before it plays.
link::Playing FlashJob::playing_on(RemoteDevice& device)
{
    for (const Milliseconds end = environment_.now() + beginning_to_play;; environment_.wait(between_looks)) {
        const auto playing = device.session().ask<link::Playing>(link::AskPlaying{});
        if (playing.is_playing || !plan_.has_scene() || environment_.now() >= end)
            return playing;
    }
}

}
