#include "tests/bench/image/harness/instruction_meter.hpp"

#include "tests/bench/image/harness/systick.hpp"

#include <utility>

namespace kfast::bench {
namespace {

// An instruction is 256/80 = 3.2 ticks. Reading the timer rounds down twice, which is less than a third of an
// instruction in all, so that rounding to nearest is exact.
constexpr std::uint32_t instructions(std::uint32_t ticks) { return (ticks * 5 + 8) / 16; }

}

void InstructionMeter::begin()
{
    systick::start(systick::mask + 1, systick::Interrupt::off);
    enter(Phase::update);
    enter(Phase::draw);
    take();
    enter(Phase::update);
    enter(Phase::draw);
    own_cost_ = take()[static_cast<std::size_t>(Phase::update)];
}

// No branches: every call must cost the same.
void InstructionMeter::enter(Phase phase)
{
    const std::uint32_t now = systick::value();
    costs_[static_cast<std::size_t>(phase_)] += instructions((entered_ - now) & systick::mask) - own_cost_;
    phase_ = phase;
    entered_ = now;
}

PhaseCosts InstructionMeter::take() { return std::exchange(costs_, {}); }

}
