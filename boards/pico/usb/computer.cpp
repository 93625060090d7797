#include "boards/pico/usb/computer.hpp"

#include "boards/pico/chip/boot_rom.hpp"
#include "boards/pico/chip/chip_flash.hpp"
#include "boards/pico/chip/memory.hpp"
#include "boards/pico/chip/watchdog.hpp"
#include "boards/pico/usb/usb_reports.hpp"
#include "firmware/link/conversation.hpp"
#include "firmware/slots/slot_store.hpp"

#include <optional>

namespace kfast::pico {
namespace {

constexpr BoardSettings no_settings;
constexpr ChipFlash chip_flash;

// Too large for the stack.
constinit std::optional<link::Stage> the_stage;
constinit std::optional<SlotStore<const ChipFlash>> slots;
constinit std::optional<link::Conversation<const UsbReports, const ChipFlash>> conversation;

void begin_with(link::StageFacts facts)
{
    facts.serial = {usb_reports.serial_number()};
    facts.board = {"pico"};
    facts.block = memory::player_block();
    facts.built_in = memory::scene_region();
    facts.has_boot_loader = true;
    the_stage.emplace(facts);
    slots.emplace(chip_flash, rp2040::slot_places);
    conversation.emplace(usb_reports, *the_stage, *slots);
    conversation->begin();
}

}

void Computer::begin(const link::StageFacts& display) const { begin_with(display); }

void Computer::begin_without_display() const
{
    begin_with({.settings = no_settings, .player_bytes = nullptr});
}

link::Stage& Computer::stage() const { return *the_stage; }

void Computer::serve() const
{
    watchdog::feed(); // looking at large scenes takes long
    conversation->serve([this] { return clock_.now(); });
    if (the_stage->is_to_leave(clock_.now()))
        boot_rom::become_drive();
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
    while (!the_stage->wants_to_begin() && !reached(clock_.now(), moment)) {
        clock_.doze_until(moment);
        serve();
    }
}

}
