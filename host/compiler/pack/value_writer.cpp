#include "host/compiler/pack/value_writer.hpp"

#include "core/scene/format.hpp"
#include "core/scene/packed_drawing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace kfast {

namespace {

/// `value` in a unit.
std::int32_t number_of(std::int32_t value, std::uint32_t unit)
{
    if (unit == kfb::values::degree_unit)
        return static_cast<std::int32_t>(std::lround(value * 360.0 / 65536));
    return value >> unit;
}

/// The values in a unit; nothing if they are not whole numbers of it.
std::optional<std::vector<std::int32_t>> numbers_of(std::span<const std::int32_t> values, std::uint32_t unit)
{
    std::vector<std::int32_t> numbers;
    for (const std::int32_t value : values) {
        numbers.push_back(number_of(value, unit));
        if (in_unit(static_cast<std::uint32_t>(numbers.back()), unit) != value)
            return std::nullopt;
    }
    return numbers;
}

void write_numbers(const std::vector<std::int32_t>& numbers, std::uint32_t unit, ByteWriter& bytes)
{
    const auto [min, max] = std::ranges::minmax(numbers);
    const auto first = static_cast<std::uint32_t>(min);
    const auto width = static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint32_t>(max) - first));
    bytes.u8(kfb::values::width.put(width) | kfb::values::unit.put(unit));
    bytes.signed_varint(min);
    BitWriter bits{bytes};
    for (const std::int32_t number : numbers)
        bits.number(static_cast<std::uint32_t>(number) - first, width);
}

}

void write_values(std::span<const std::int32_t> values, ByteWriter& bytes)
{
    if (values.size() == 1)
        return bytes.signed_varint(values.front());
    std::optional<ByteWriter> best;
    for (std::uint32_t unit = 0; unit <= kfb::values::degree_unit; ++unit)
        if (const auto numbers = numbers_of(values, unit)) {
            ByteWriter written;
            write_numbers(*numbers, unit, written);
            if (!best || written.size() < best->size())
                best = std::move(written);
        }
    bytes.append(best->bytes());
}

}
