#include "boards/pico/parallel_bus.hpp"

#include "boards/pico/dma.hpp"
#include "boards/pico/register.hpp"
#include "boards/pico/resets.hpp"
#include "boards/pico/write_program.hpp"

namespace kfast::pico {
namespace {

// PIO0 and its state machine 0
constexpr Register control{0x5020'0000};
constexpr Register fifo_status{0x5020'0004};
constexpr Register events{0x5020'0008};
constexpr Register transmit{0x5020'0010};
constexpr Register program_memory(std::uint32_t at) { return Register{0x5020'0048 + 4 * at}; }
constexpr Register clock_divisor{0x5020'00C8};
constexpr Register execution{0x5020'00CC};
constexpr Register shifting{0x5020'00D0};
constexpr Register execute_now{0x5020'00D8};
constexpr Register pin_ranges{0x5020'00DC};

constexpr std::uint32_t machine_enable = 1 << 0;
constexpr std::uint32_t machine_restart = 1 << 4;
constexpr std::uint32_t transmit_full = 1 << 16;
constexpr std::uint32_t transmit_empty = 1 << 24;
constexpr std::uint32_t stalled = 1 << 24; // in `events`, kept until a 1 is written
constexpr int divisor_at = 16;
constexpr int wrap_from_at = 12;
constexpr std::uint32_t refill_by_itself = 1 << 17; // shifting left, the highest bits first
constexpr int refill_after_at = 25;
constexpr std::uint32_t one_side_set_pin = 1u << 29;
constexpr std::uint32_t one_set_pin = 1u << 26;
constexpr std::uint32_t eight_out_pins = 8u << 20;
constexpr int side_set_base_at = 10;
constexpr int set_base_at = 5;

constexpr int data_pin_count = 8;

void drive_pins(Pin data, Pin write)
{
    pin_ranges.write(one_set_pin | eight_out_pins | static_cast<std::uint32_t>(write) << set_base_at | data);
    execute_now.write(pio::set_pins_1);
    execute_now.write(pio::set_directions_1);
    execute_now.write(pio::mov_osr_ones);
    execute_now.write(pio::out_directions_8);
    pin_ranges.write(one_side_set_pin | eight_out_pins |
                     static_cast<std::uint32_t>(write) << side_set_base_at | data);
}

void load_program(const WriteCycle& cycle)
{
    const auto program = pio::write_program(cycle);
    for (std::uint32_t at = 0; at < program.size(); ++at)
        program_memory(at).write(program[at]);
    clock_divisor.write(cycle.divisor << divisor_at);
    execution.write((program.size() - 1) << wrap_from_at);
}

// A byte counts as one piece, a word of two bytes as another: the machine forgets what it has taken of the
// last one, or it would send the rest of it.
void run_with_pieces_of(std::uint32_t bits)
{
    control.write(0);
    shifting.write(refill_by_itself | bits << refill_after_at);
    control.write(machine_restart);
    execute_now.write(pio::jump_to_0 | pio::side_high);
    control.write(machine_enable);
}

}

ParallelBus::ParallelBus(const BoardSettings& settings)
    : select_{settings.pin(PinRole::select), Pad::fast_output}, dc_{settings.pin(PinRole::dc),
                                                                    Pad::fast_output}
{
    const Pin data = settings.pin(PinRole::data);
    const Pin write = settings.pin(PinRole::clock);
    resets::restart(resets::pio0);
    control.write(0);
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
    dma::start(bytes, dma::Piece::byte, transmit, dma::Request::pio0_tx0);
}

void ParallelBus::start_words(std::span<const std::byte> words)
{
    dc_.high();
    select(16);
    dma::start(words, dma::Piece::word_16, transmit, dma::Request::pio0_tx0);
}

// The machine stalls where WR has risen and no data is left. It may have stalled earlier too, waiting for
// memory, so the stall that counts is one after it has taken the last piece.
bool ParallelBus::busy()
{
    if (dma::busy() || (fifo_status.read() & transmit_empty) == 0)
        return true;
    if (!waits_for_last_write_) {
        waits_for_last_write_ = true;
        events.write(stalled);
    }
    return (events.read() & stalled) == 0;
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
        while ((fifo_status.read() & transmit_full) != 0) {
        }
        transmit.write(std::to_integer<std::uint32_t>(byte) << 24);
    }
    while (busy()) {
    }
}

}
