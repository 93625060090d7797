#include "core/scene/number_text.hpp"

#include "core/math/fixed.hpp"
#include "core/scene/format.hpp"

#include <algorithm>

namespace kfast {

namespace {

/// The last digit that is shown, in 1/1000 x 1/whole_input.
std::uint32_t unit_of(std::uint32_t decimals)
{
    std::uint32_t thousandths = 1000;
    for (; decimals > 0; --decimals)
        thousandths /= 10;
    return thousandths * static_cast<std::uint32_t>(whole_input.ticks);
}

}

[[gnu::cold]] NumberText::NumberText(const NumberFormat& format, const InputView& input, Time place)
{
    const std::int64_t range = std::int64_t{input.max} - input.min;
    const std::int64_t value = std::int64_t{input.min} * whole_input.ticks + range * place.ticks;
    const std::uint32_t unit = unit_of(format.decimals);
    const auto size = static_cast<std::uint64_t>(value < 0 ? -value : value);
    const auto number = static_cast<std::uint32_t>(quotient(size + unit / 2, unit));
    put_before(format.behind);
    const std::uint32_t digits = put_number_before(format, number);
    if (value < 0 && number != 0)
        put_before(kfb::number_glyph::minus);
    for (std::uint32_t gaps = digits; gaps < format.places; ++gaps)
        put_before(kfb::number_glyph::gap);
    put_before(format.before);
}

/// Returns how many digits are before the point.
std::uint32_t NumberText::put_number_before(const NumberFormat& format, std::uint32_t number)
{
    std::uint32_t digits = 0;
    for (; number != 0 || digits < format.decimals + format.digits; ++digits) {
        if (digits == format.decimals && digits != 0)
            put_before(kfb::number_glyph::point);
        put_before(number % 10);
        number /= 10;
    }
    return digits - format.decimals;
}

void NumberText::put_before(std::span<const std::byte> glyphs)
{
    for (std::size_t left = glyphs.size(); left > 0; --left)
        put_before(std::to_integer<std::uint32_t>(glyphs[left - 1]));
}

std::uint32_t max_glyphs(const NumberFormat& format, const InputView& input)
{
    const NumberText least{format, input, {}};
    const NumberText greatest{format, input, whole_input};
    return static_cast<std::uint32_t>(std::max(least.glyphs().size(), greatest.glyphs().size()));
}

}
