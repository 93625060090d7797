#include "boards/pico/panel/parallel_bus.hpp"

#include "boards/pico/chip/dma.hpp"
#include "boards/pico/chip/pio_unit.hpp"
#include "boards/pico/chip/resets.hpp"
#include "boards/pico/panel/write_program.hpp"

namespace kfast::pico {
namespace {

constexpr pio::Machine machine{0};
constexpr std::uint32_t pinctrl_out_count_8 = 8u << pio::pinctrl_out_count_lsb;

constexpr int data_pin_count = 8;

void drive_pins(Pin data, Pin write)
{
    machine.pinctrl().write(pio::pinctrl_set_count_1 | pinctrl_out_count_8 |
                            static_cast<std::uint32_t>(write) << pio::pinctrl_set_base_lsb | data);
    machine.instr().write(pio::set_pins(1));
    machine.instr().write(pio::set_pindirs_1);
    machine.instr().write(pio::mov_osr_not_null);
    machine.instr().write(pio::out_pindirs_8);
    machine.pinctrl().write(pio::pinctrl_sideset_count_1 | pinctrl_out_count_8 |
                            static_cast<std::uint32_t>(write) << pio::pinctrl_sideset_base_lsb | data);
}

void load_program(const WriteCycle& cycle)
{
    const auto program = pio::write_program(cycle);
    for (std::uint32_t at = 0; at < program.size(); ++at)
        pio::instr_mem(at).write(program[at]);
    machine.clkdiv().write(cycle.divisor << pio::clkdiv_int_lsb);
    machine.execctrl().write((program.size() - 1) << pio::execctrl_wrap_top_lsb);
}

// A byte counts as one piece, a word of two bytes as another: the machine drops what it has taken of the
// last one, or it would send the rest of it.
void run_with_pieces_of(std::uint32_t bits)
{
    pio::ctrl.write(0);
    machine.shiftctrl().write(pio::shiftctrl_autopull | bits << pio::shiftctrl_pull_thresh_lsb);
    pio::ctrl.write(pio::ctrl_sm_restart);
    machine.instr().write(pio::jmp(0) | pio::side_1);
    pio::ctrl.write(pio::ctrl_sm_enable);
}

}

ParallelBus::ParallelBus(const BoardSettings& settings)
    : select_{settings.pin(PinRole::select), Pad::fast_output},
      dc_{settings.pin(PinRole::dc), Pad::fast_output}
{
    const Pin data = settings.pin(PinRole::data);
    const Pin write = settings.pin(PinRole::clock);
    resets::restart(resets::pio0);
    pio::ctrl.write(0);
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
    dma::start(bytes, dma::DataSize::byte, machine.txf(), dma::Dreq::pio0_tx0);
}

void ParallelBus::start_words(std::span<const std::byte> words)
{
    dc_.high();
    select(16);
    dma::start(words, dma::DataSize::halfword, machine.txf(), dma::Dreq::pio0_tx0);
}

// The machine stalls where WR has risen and no data is left. It may have stalled earlier too, waiting for
// memory, so the stall that counts is one after it has taken the last piece.
bool ParallelBus::busy()
{
    if (dma::busy() || (pio::fstat.read() & pio::fstat_txempty) == 0)
        return true;
    if (!waits_for_last_write_) {
        waits_for_last_write_ = true;
        pio::fdebug.write(pio::fdebug_txstall);
    }
    return (pio::fdebug.read() & pio::fdebug_txstall) == 0;
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
        while ((pio::fstat.read() & pio::fstat_txfull) != 0) {
        }
        machine.txf().write(std::to_integer<std::uint32_t>(byte) << 24);
    }
    while (busy()) {
    }
}

}
