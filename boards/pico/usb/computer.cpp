#include "boards/pico/usb/computer.hpp"

#include "boards/pico/chip/boot_rom.hpp"
#include "boards/pico/chip/chip_flash.hpp"
#include "boards/pico/chip/memory.hpp"
#include "boards/pico/chip/watchdog.hpp"
#include "boards/pico/usb/usb_reports.hpp"
#include "firmware/link/link_service.hpp"
#include "firmware/slots/slot_store.hpp"

#include <optional>

namespace kfast::pico {
namespace {

constexpr BoardSettings no_settings;
constexpr ChipFlash chip_flash;

// Too large for the stack.
constinit std::optional<link::PlaybackSession> playback_session;
constinit std::optional<SlotStore<const ChipFlash>> slots;
constinit std::optional<link::LinkService<const UsbReports, const ChipFlash>> link_service;

[[gnu::cold, gnu::noinline]] void begin_with(link::BoardFacts facts)
{
    facts.serial = {usb_reports.serial_number()};
    facts.board = {"pico"};
    facts.block = memory::player_block();
    facts.built_in = memory::scene_region();
    facts.has_boot_loader = true;
    facts.restarts = link::restarts_at_start(watchdog::kept(), watchdog::has_restarted());
    facts.keep = watchdog::keep;
    playback_session.emplace(facts);
    slots.emplace(chip_flash, rp2040::slot_places);
    link_service.emplace(usb_reports, *playback_session, *slots);
    link_service->begin();
}

}

void Computer::begin(const link::BoardFacts& display) const { begin_with(display); }

void Computer::begin_without_display() const
{
    begin_with({.settings = no_settings, .player_bytes = nullptr});
}

link::PlaybackSession& Computer::playback() const { return *playback_session; }

void Computer::serve() const
{
    watchdog::feed(); // checking large scenes takes long
    link_service->serve([this] { return clock_.now(); });
    if (playback_session->is_to_leave(clock_.now())) {
        watchdog::keep(0); // the boot loader starts the firmware by the watchdog
        boot_rom::become_drive();
    }
}

void Computer::serve_until(Microseconds moment) const
{
    serve();
    while (!reached(clock_.now(), moment)) {
        clock_.doze_until(moment);
        serve();
    }
}

void Computer::serve_until_change(Microseconds moment) const
{
    serve();
    while (!playback_session->wants_to_begin() && !reached(clock_.now(), moment)) {
        clock_.doze_until(moment);
        serve();
    }
}

}
