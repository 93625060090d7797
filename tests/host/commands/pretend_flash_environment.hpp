#pragma once

#include "core/scene/scene_view.hpp"
#include "host/commands/flash/flash_environment.hpp"
#include "host/config/firmware_images.hpp"
#include "host/config/pico_flash.hpp"
#include "host/program/interruption.hpp"
#include "tests/host/flash/pretend_boot_loader.hpp"
#include "tests/host/link/device_pipe.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace kfast::test {

/// A Pico on a desk, with all of its flash. It starts as its boot ROM does: the firmware if there is one,
/// else the boot loader.
struct DeskPico {
    enum class State { unplugged, in_boot_loader, running };

    explicit DeskPico(std::string place, std::string number)
        : port{std::move(place)}, serial{std::move(number)}
    {
    }

    void start()
    {
        state = config::begins_with_boot_block(flash.bytes()) ? State::running : State::in_boot_loader;
        player.device.is_in_boot_loader = false;
        player.device.now.is_playing = plays_slot || has_scene();
        player.device.now.home = plays_slot ? link::Home::slot : link::Home::built_in;
        player.device.now.slot = plays_slot ? std::uint8_t{2} : link::no_slot;
        ++starts;
    }
    void leave()
    {
        is_leaving = false;
        start();
    }
    bool has_scene() { return static_cast<bool>(SceneView::parse(flash.read(pico_flash::scene, 0x10000))); }

    std::string port;
    std::string serial;
    State state = State::in_boot_loader;
    BootChip chip = BootChip::rp2040;
    NorFlash flash{512};
    LinkBench player;
    PretendBootLoader boot_loader{flash};
    bool plays_slot = false; ///< the slot 2
    bool is_deaf = false;    ///< stays in its player, whatever it is told
    int starts = 0;
    int lingers = 0; ///< how often it is still seen after it was told to restart
    bool is_leaving = false;
    int forbidden = 0; ///< how often it may not be opened yet
    int unready = 0;   ///< how often its boot loader cannot be used yet
    bool has_picoboot = true;
};

class DeskBootLoader final : public BootLoader {
public:
    explicit DeskBootLoader(DeskPico& pico) : pico_{pico} {}

    void read(std::uint32_t address, std::span<std::byte> bytes) override
    {
        pico_.boot_loader.read(address, bytes);
    }
    void erase(std::uint32_t address, std::size_t bytes) override { pico_.boot_loader.erase(address, bytes); }
    void write(std::uint32_t address, std::span<const std::byte> bytes) override
    {
        pico_.boot_loader.write(address, bytes);
    }
    void restart() override
    {
        pico_.is_leaving = pico_.lingers > 0;
        if (!pico_.is_leaving)
            pico_.start();
    }

private:
    DeskPico& pico_;
};

/// Picos and drives on a desk, where time passes only while somebody waits.
class PretendFlashEnvironment final : public FlashEnvironment {
public:
    static constexpr int always = 1'000'000;

    DeskPico& add(const std::string& port, const std::string& serial = "E66058388341A22C")
    {
        return picos.emplace_back(port, serial);
    }

    std::vector<BootBoard> boards_in_boot_loader() override
    {
        if (on_boards)
            on_boards();
        std::vector<BootBoard> boards;
        for (DeskPico& pico : picos) {
            if (pico.is_leaving && pico.lingers-- == 0)
                pico.leave();
            if (pico.player.device.is_in_boot_loader && !pico.is_deaf)
                pico.state = DeskPico::State::in_boot_loader;
            if (pico.state == DeskPico::State::in_boot_loader)
                boards.push_back({pico.chip, pico.port});
        }
        return boards;
    }
    std::unique_ptr<BootLoader> open_boot_loader(const BootBoard& board) override
    {
        DeskPico& pico = *std::ranges::find(picos, board.port, &DeskPico::port);
        require_permission(pico);
        if (!pico.has_picoboot)
            throw NoPicoboot{};
        if (pico.unready > 0) {
            --pico.unready;
            throw Failure{"USB fails", ExitStatus::refused};
        }
        return std::make_unique<DeskBootLoader>(pico);
    }

    std::vector<DeviceAddress> attached_devices() override
    {
        std::vector<DeviceAddress> devices;
        for (const DeskPico& pico : picos)
            if (pico.state == DeskPico::State::running)
                devices.push_back({DeviceAddress::Way::usb, pico.port, pico.serial});
        return devices;
    }
    RemoteDevice open_device(const DeviceAddress& address, Milliseconds last_patience) override
    {
        DeskPico& pico = *std::ranges::find(picos, address.path, &DeskPico::port);
        require_permission(pico);
        return {std::make_unique<DevicePipe>(pico.player), {last_patience, 1}, address.serial};
    }

    std::vector<Uf2Drive> uf2_drives() override { return drives; }
    Uf2Drive uf2_drive_at(const std::string& folder) override
    {
        const auto found = std::ranges::find(drives, std::filesystem::path{folder}, &Uf2Drive::folder);
        if (found == drives.end())
            throw Failure{"no drive", ExitStatus::no_device};
        return *found;
    }
    void copy_to_drive(const Uf2Drive&, const FlashImage& image, const FlashProgressCallback&) override
    {
        if (is_full)
            throw Failure{"the drive is gone", ExitStatus::unplugged};
        for (const FlashImage::Sector& sector : image.sectors()) {
            picos.front().boot_loader.erase(sector.address, sector.bytes.size());
            picos.front().boot_loader.write(sector.address, sector.bytes);
        }
        picos.front().start();
    }

    void enter_boot_loader(const BootLines& lines) override
    {
        pulled = lines.reset + " " + lines.boot;
        if (on_lines)
            on_lines();
    }

    Milliseconds now() const override { return now_; }
    void wait(Milliseconds time) override
    {
        heed_interruption();
        now_ += time;
        if (on_wait)
            on_wait();
    }

    std::deque<DeskPico> picos; // which stay where they are
    std::vector<Uf2Drive> drives;
    bool is_full = false;
    std::string pulled;              ///< lines
    std::function<void()> on_boards; ///< before they are listed
    std::function<void()> on_lines;
    std::function<void()> on_wait;

private:
    static void require_permission(DeskPico& pico)
    {
        if (pico.forbidden == 0)
            return;
        --pico.forbidden;
        throw Failure{"you may not", ExitStatus::no_permission};
    }

    Milliseconds now_{0};
};

}
