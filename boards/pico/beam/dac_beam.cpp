#include "boards/pico/beam/dac_beam.hpp"

#include "boards/pico/beam/dac_program.hpp"
#include "boards/pico/beam/looped_words.hpp"
#include "boards/pico/beam/shutter.hpp"
#include "boards/pico/chip/pins.hpp"
#include "boards/pico/chip/pio_unit.hpp"
#include "boards/pico/chip/resets.hpp"
#include "firmware/run/dac_point.hpp"

#include <array>

namespace kfast::pico {
namespace {

using looped_words::Loop;

constexpr pio::Machine dac_output{0};
constexpr pio::Machine clock{1};
constexpr std::uint32_t both_machines = 3;

/// 41 ms at 100,000 points a second, as long as most profiles allow; 16 KiB each, of which two take no more
/// than the bands of a panel.
constexpr std::size_t max_points = 4096;

/// Wherever these are, no loop is right in front of another (looped_words.hpp).
template <std::size_t size>
struct Picture {
    std::array<std::uint32_t, size> points;
    Loop loop;
};

std::array<Picture<max_points>, 2> pictures;
Picture<1> parked;

/// A laser may shine for 2 ms at one point.
constexpr std::uint32_t still_lights_in_second = 500;

/// Gives a pin to the machine that has a side-set, set or out pin there, and its level at the beginning.
void drive(const pio::Machine& machine, Pin pin, std::uint32_t level)
{
    machine.pinctrl().write(pio::pinctrl_set_count_1 | static_cast<std::uint32_t>(pin)
                                                           << pio::pinctrl_set_base_lsb);
    machine.instr().write(pio::set_pins(level));
    machine.instr().write(pio::set_pindirs_1);
}

template <std::size_t size>
void load(const pio::Machine& machine, const std::array<std::uint32_t, size>& program, std::uint32_t place)
{
    for (std::uint32_t at = 0; at < size; ++at)
        pio::instr_mem(place + at).write(program[at]);
    machine.execctrl().write((place + size - 1) << pio::execctrl_wrap_top_lsb |
                             place << pio::execctrl_wrap_bottom_lsb);
    machine.shiftctrl().write(0); // to the left, nothing by itself
}

void give(const pio::Machine& machine, std::uint32_t word, std::uint32_t take_over)
{
    machine.txf().write(word);
    machine.instr().write(pio::pull);
    machine.instr().write(take_over);
}

std::uint32_t range(Pin pin, int at) { return static_cast<std::uint32_t>(pin) << at; }

void set_up_dac_output(const BoardSettings& settings, std::uint32_t default_point)
{
    const Pin bits = settings.pin(PinRole::clock);
    const Pin data = settings.pin(PinRole::data);
    const Pin select = settings.pin(PinRole::select);
    const rp2040::DacBit bit = rp2040::dac_bit(settings.bus_clock);
    load(dac_output, pio::dac_output_program(bit), 0);
    dac_output.clkdiv().write(bit.divisor << pio::clkdiv_int_lsb);
    drive(dac_output, bits, 0);
    drive(dac_output, data, 1);
    drive(dac_output, select, 1);
    dac_output.pinctrl().write(pio::pinctrl_sideset_count_1 | range(bits, pio::pinctrl_sideset_base_lsb) |
                               pio::pinctrl_set_count_1 | range(select, pio::pinctrl_set_base_lsb) |
                               1u << pio::pinctrl_out_count_lsb | range(data, pio::pinctrl_out_base_lsb));
    give(dac_output, default_point, pio::mov_isr_osr);
    dac_output.instr().write(pio::jmp(0));
    for (const Pin pin : {bits, data, select})
        connect(pin, PinFunction::pio0, Pad::fast_output);
}

void set_up_clock(const BoardSettings& settings, std::uint32_t place)
{
    const Pin ldac = settings.pin(PinRole::ldac);
    const Pin blank = settings.pin(PinRole::blank);
    const pio::PointClock points = pio::point_clock(rp2040::cycles_per_point(settings.beam.rate));
    load(clock, pio::point_clock_program(points, place), place);
    clock.clkdiv().write(1 << pio::clkdiv_int_lsb);
    drive(clock, ldac, 1);
    drive(clock, blank, 1);
    clock.pinctrl().write(pio::pinctrl_sideset_count_1 | range(ldac, pio::pinctrl_sideset_base_lsb) |
                          range(settings.pin(PinRole::data), pio::pinctrl_in_base_lsb) |
                          1u << pio::pinctrl_out_count_lsb | range(blank, pio::pinctrl_out_base_lsb));
    give(clock, points.turns, pio::mov_y_osr);
    clock.instr().write(pio::jmp(place) | pio::side_1);
    connect(ldac, PinFunction::pio0, Pad::fast_output);
    shutter::hand_over();
}

}

DacBeam::DacBeam(const BoardSettings& settings)
    : profile_{settings.beam}, still_light_{settings.beam.rate / still_lights_in_second}
{
    parked.points[0] = dac_point({.at = profile_.park}, profile_.brightness);
    parked.loop = Loop{parked.points};
    resets::restart(resets::pio0);
    set_up_dac_output(settings, parked.points[0]);
    set_up_clock(settings, static_cast<std::uint32_t>(pio::dac_output_program({}).size()));
    looped_words::begin(parked.loop, dac_output.txf(), dma::Dreq::pio0_tx0);
    pio::ctrl.write(both_machines * (pio::ctrl_sm_enable | pio::ctrl_clkdiv_restart));
}

std::uint32_t DacBeam::room() const { return max_points; }

bool DacBeam::takes_picture() const { return looped_words::has_gone_over(); }

void DacBeam::plot(std::span<const BeamPoint> points)
{
    for (const BeamPoint& point : points) {
        const std::uint32_t word = dac_point(point, profile_.brightness);
        pictures[plotted_].points[points_++] = profile_.is_laser ? still_light_.passed(word) : word;
    }
}

void DacBeam::show()
{
    auto& [words, loop] = pictures[plotted_];
    const auto picture = std::span{words}.first(points_);
    if (profile_.is_laser)
        still_light_.end(picture);
    loop = Loop{picture};
    looped_words::go_over_to(loop);
    plotted_ = 1 - plotted_;
    points_ = 0;
    shutter::set_busy(true);
}

void DacBeam::park()
{
    shutter::set_busy(false);
    looped_words::go_over_to(parked.loop);
    points_ = 0;
}

}
