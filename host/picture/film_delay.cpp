#include "host/picture/film_delay.hpp"

#include "core/time/time.hpp"

#include <limits>

namespace kfast {
namespace {

constexpr std::int64_t max = std::numeric_limits<std::uint16_t>::max();

struct Ratio {
    std::int64_t numerator;
    std::int64_t denominator;
};

}

FilmDelay film_delay(std::int64_t ticks, std::uint32_t frame_rate)
{
    Ratio rest{ticks * 1000, std::int64_t{frame_rate} * Time::ticks_per_frame};
    if (rest.numerator / rest.denominator >= max)
        return {static_cast<std::uint16_t>(max), 1, false};
    Ratio before{1, 0};
    Ratio last{rest.numerator / rest.denominator, 1};
    rest = {rest.denominator, rest.numerator % rest.denominator};
    while (rest.denominator != 0) {
        const std::int64_t step = rest.numerator / rest.denominator;
        const Ratio next{step * last.numerator + before.numerator,
                         step * last.denominator + before.denominator};
        if (next.numerator > max || next.denominator > max)
            break;
        before = last;
        last = next;
        rest = {rest.denominator, rest.numerator % rest.denominator};
    }
    return {static_cast<std::uint16_t>(last.numerator), static_cast<std::uint16_t>(last.denominator),
            rest.denominator == 0};
}

}
