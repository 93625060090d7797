#include "boards/pico/panel/parallel_bus.hpp"

#include "boards/pico/chip/dma.hpp"
#include "boards/pico/chip/pio_unit.hpp"
#include "boards/pico/chip/resets.hpp"
#include "boards/pico/panel/write_program.hpp"

namespace kfast::pico {
namespace {

constexpr pio::Machine machine{0};
constexpr std::uint32_t eight_out_pins = 8u << pio::out_pins_at;

constexpr int data_pin_count = 8;

void drive_pins(Pin data, Pin write)
{
    machine.pin_ranges().write(pio::one_set_pin | eight_out_pins |
                               static_cast<std::uint32_t>(write) << pio::set_base_at | data);
    machine.execute_now().write(pio::set_pins(1));
    machine.execute_now().write(pio::set_directions_1);
    machine.execute_now().write(pio::mov_osr_ones);
    machine.execute_now().write(pio::out_directions_8);
    machine.pin_ranges().write(pio::one_side_set_pin | eight_out_pins |
                               static_cast<std::uint32_t>(write) << pio::side_set_base_at | data);
}

void load_program(const WriteCycle& cycle)
{
    const auto program = pio::write_program(cycle);
    for (std::uint32_t at = 0; at < program.size(); ++at)
        pio::program_memory(at).write(program[at]);
    machine.clock_divisor().write(cycle.divisor << pio::divisor_at);
    machine.execution().write((program.size() - 1) << pio::wrap_from_at);
}

// A byte counts as one piece, a word of two bytes as another: the machine forgets what it has taken of the
// last one, or it would send the rest of it.
void run_with_pieces_of(std::uint32_t bits)
{
    pio::control.write(0);
    machine.shifting().write(pio::refill_by_itself | bits << pio::refill_after_at);
    pio::control.write(pio::machine_restart);
    machine.execute_now().write(pio::jump(0) | pio::side_high);
    pio::control.write(pio::machine_enable);
}

}

ParallelBus::ParallelBus(const BoardSettings& settings)
    : select_{settings.pin(PinRole::select), Pad::fast_output}, dc_{settings.pin(PinRole::dc),
                                                                    Pad::fast_output}
{
    const Pin data = settings.pin(PinRole::data);
    const Pin write = settings.pin(PinRole::clock);
    resets::restart(resets::pio0);
    pio::control.write(0);
    dma::begin();
    load_program(write_cycle(settings.bus_clock));
    drive_pins(data, write);
    connect(write, PinFunction::pio0, Pad::fast_output);
    for (int i = 0; i < data_pin_count; ++i)
        connect(static_cast<Pin>(data + i), PinFunction::pio0, Pad::fast_output);
}

void ParallelBus::command(std::span<const std::byte> bytes)
{
    dc_.low();
    send(bytes);
}

void ParallelBus::parameters(std::span<const std::byte> bytes)
{
    dc_.high();
    send(bytes);
}

// A write that is narrower than a register reaches all its parts: the highest bits are the byte or the word.

void ParallelBus::start_data(std::span<const std::byte> bytes)
{
    dc_.high();
    select(8);
    dma::start(bytes, dma::Piece::byte, machine.transmit(), dma::Request::pio0_tx0);
}

void ParallelBus::start_words(std::span<const std::byte> words)
{
    dc_.high();
    select(16);
    dma::start(words, dma::Piece::word_16, machine.transmit(), dma::Request::pio0_tx0);
}

// The machine stalls where WR has risen and no data is left. It may have stalled earlier too, waiting for
// memory, so the stall that counts is one after it has taken the last piece.
bool ParallelBus::busy()
{
    if (dma::busy() || (pio::fifo_status.read() & pio::transmit_empty) == 0)
        return true;
    if (!waits_for_last_write_) {
        waits_for_last_write_ = true;
        pio::events.write(pio::stalled);
    }
    return (pio::events.read() & pio::stalled) == 0;
}

void ParallelBus::select(std::uint32_t piece_bits)
{
    select_.high();
    if (piece_bits_ != piece_bits)
        run_with_pieces_of(piece_bits);
    piece_bits_ = piece_bits;
    waits_for_last_write_ = false;
    select_.low();
}

void ParallelBus::send(std::span<const std::byte> bytes)
{
    select(8);
    for (const std::byte byte : bytes) {
        while ((pio::fifo_status.read() & pio::transmit_full) != 0) {
        }
        machine.transmit().write(std::to_integer<std::uint32_t>(byte) << 24);
    }
    while (busy()) {
    }
}

}
