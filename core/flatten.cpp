#include "core/flatten.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdlib>
#include <limits>

namespace kfast {
namespace {

constexpr int spare_bits = 2; ///< the sum of four coordinates has these more

/// |a - 2 b + c| in 1/16384 px, at most 1/8 too much.
std::int32_t bend(Point a, Point b, Point c)
{
    const auto of = [](Fixed from, Fixed by, Fixed to) {
        return ((from - by).raw() >> spare_bits) + ((to - by).raw() >> spare_bits);
    };
    return rough_length(of(a.x, b.x, c.x), of(a.y, b.y, c.y));
}

constexpr int most_freely = 32; ///< pieces: beyond it, powers of two
constexpr int ratio_bits = 29;

constexpr int halvings_of(int pieces)
{
    return static_cast<int>(std::bit_width(static_cast<unsigned>(pieces - 1)));
}

/// (2^halvings / n)^3 for n pieces; up to 8.
constexpr auto ratios = [] {
    std::array<std::uint32_t, most_freely> table{};
    for (std::size_t n = 3; n < table.size(); ++n) {
        const std::uint64_t cube = n * n * n;
        table[n] = static_cast<std::uint32_t>(
            ((std::uint64_t{1} << (3 * halvings_of(static_cast<int>(n)) + ratio_bits)) + cube / 2) / cube);
    }
    return table;
}();

/// value * ratio, rounded to nearest, halves up; value is signed, and the result fits. Small processors
/// multiply 64 bits by a function: so the halves are multiplied, and what their sum drops is added apart.
std::uint32_t scaled(std::uint32_t value, std::uint32_t ratio)
{
    constexpr int bits = ratio_bits - 16;
    constexpr std::uint32_t dropped = (1U << bits) - 1;
    const std::uint32_t low = value & 0xFFFF;
    const auto high = static_cast<std::uint32_t>(static_cast<std::int32_t>(value) >> 16);
    const std::uint32_t a = high * (ratio & 0xFFFF); // signed
    const std::uint32_t b = low * (ratio >> 16);
    const std::uint32_t rest =
        (a & dropped) + (b & dropped) + (low * (ratio & 0xFFFF) >> 16) + (1U << (bits - 1));
    return (high * (ratio >> 16) << (32 - ratio_bits)) +
           static_cast<std::uint32_t>(static_cast<std::int32_t>(a) >> bits) + (b >> bits) + (rest >> bits);
}

std::uint64_t scaled(std::uint64_t value, std::uint32_t ratio)
{
    const auto high = static_cast<std::uint64_t>(static_cast<std::int64_t>(value) >> 32);
    const std::uint64_t low = (value & 0xFFFF'FFFF) * ratio + (1U << (ratio_bits - 1));
    return (high * ratio << (32 - ratio_bits)) + (low >> ratio_bits);
}

}

template <class Word>
CubicSteps<Word>::CubicSteps(int pieces, Fixed c1, Fixed c2, Fixed to)
{
    const int halvings = halvings_of(pieces);
    if constexpr (std::is_same_v<FractionBits, int>)
        fraction_bits_ = 3 * halvings;
    const auto word = [](Fixed value) { return static_cast<Word>(value.raw()); };
    const auto n = static_cast<Word>(pieces);
    const Word slope = 3 * word(c1);
    const Word square = 3 * (word(c2) - 2 * word(c1));
    const Word cube = word(to) - 3 * (word(c2) - word(c1));
    const auto divided = [this, pieces, halvings](Word cubed) { // by n^3
        const Word shifted = cubed << (fraction_bits_ - 3 * halvings);
        return (pieces & (pieces - 1)) == 0 // small processors count bits by a function
                   ? shifted
                   : scaled(shifted, ratios[static_cast<std::size_t>(pieces)]);
    };
    value_ = Word{1} << (fraction_bits_ - 1);
    first_ = divided((slope * n + square) * n + cube);
    third_ = divided(6 * cube);
    second_ = divided(2 * square * n) + third_;
}

template class CubicSteps<std::uint32_t>;
template class CubicSteps<std::uint64_t>;

bool is_small(const Segment& cubic, int pieces)
{
    const int room = std::max(4 - pieces, 0) + 1; // for second differences: 24 times the reach / pieces^2
    const std::int32_t reach = std::numeric_limits<std::int32_t>::max() >> (3 * halvings_of(pieces) + room);
    const auto is_near = [&cubic, reach](Point point) {
        const Point away = point - cubic.from;
        return std::abs(away.x.raw()) <= reach && std::abs(away.y.raw()) <= reach;
    };
    return is_near(cubic.c1) && is_near(cubic.c2) && is_near(cubic.to);
}

int pieces_for(const Segment& segment)
{
    if (segment.kind == Segment::Kind::line)
        return 1;
    const std::int32_t bent =
        std::max(bend(segment.from, segment.c1, segment.c2), bend(segment.c1, segment.c2, segment.to));
    constexpr std::int32_t limit = (flatness.raw() * 4 / 3) >> spare_bits;
    int pieces = 1;
    while (pieces < most_pieces && pieces * pieces * limit < bent)
        pieces = pieces < most_freely ? pieces + 1 : 2 * pieces;
    return pieces;
}

}
