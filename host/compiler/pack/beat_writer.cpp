#include "host/compiler/pack/beat_writer.hpp"

#include "host/compiler/pack/bit_writer.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace kfast {
namespace {

constexpr int most_shift = 15;
constexpr std::uint32_t input_bit = 1 << 15;

/// The time of each since the one before.
std::vector<std::uint32_t> steps_of(const Beats& beats)
{
    std::vector<std::uint32_t> steps;
    Time before;
    for (const WrittenBeat& beat : beats) {
        steps.push_back(static_cast<std::uint32_t>((beat.time - before).ticks));
        before = beat.time;
    }
    return steps;
}

std::uint32_t bits_for(std::uint32_t largest) { return static_cast<std::uint32_t>(std::bit_width(largest)); }

/// A single beat is the same by any clock.
Clock told_clock(const ClockedBeats& beats) { return beats.beats.size() == 1 ? Clock{} : beats.clock; }

}

void write_beats(const ClockedBeats& clocked, const ClockedBeats& usual, ByteWriter& bytes)
{
    const auto& beats = clocked.beats;
    const Clock clock = told_clock(clocked);
    if (beats == usual.beats && clock == told_clock(usual))
        return bytes.varint(0);
    const std::vector<std::uint32_t> steps = steps_of(beats);
    const std::uint32_t all_bits = std::reduce(steps.begin(), steps.end(), 0U, std::bit_or{});
    const int shift = all_bits == 0 ? 0 : std::min(std::countr_zero(all_bits), most_shift);
    const std::uint32_t time_bits = bits_for(std::ranges::max(steps) >> shift);
    const std::uint32_t law_bits = bits_for(std::ranges::max(beats, {}, &WrittenBeat::laws).laws);
    bytes.varint(static_cast<std::uint32_t>(beats.size()));
    bytes.u16(time_bits | static_cast<std::uint32_t>(shift) << 5 | law_bits << 9 |
              (clock.is_time() ? 0 : input_bit));
    if (!clock.is_time())
        bytes.u8(clock.input);
    BitWriter bits{bytes};
    for (std::size_t i = 0; i < beats.size(); ++i) {
        bits.number(steps[i] >> shift, time_bits);
        bits.number(beats[i].laws, law_bits);
    }
}

}
