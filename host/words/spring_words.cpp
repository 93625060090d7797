#include "host/words/spring_words.hpp"

#include "host/text/number_text.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace kfast {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double decay_unit = 1 << Oscillation::decay_bits;
constexpr double turn_unit = 1 << Oscillation::turn_bits;
constexpr double lean_unit = 1 << Oscillation::lean_bits;
constexpr double size_unit = 1 << Oscillation::size_bits;
constexpr double steepest_lean = 15.9;
constexpr double elastic_decay = 10;

/// Of numbers that are rounded already: what is rounded ends at 1, too.
double size_for(const Oscillation& rounded)
{
    const double angle = 2 * pi * rounded.turns / turn_unit;
    const double wave = std::cos(angle) + rounded.lean / lean_unit * std::sin(angle);
    return 1 / (1 - std::exp2(-rounded.decay / decay_unit) * wave);
}

Oscillation oscillation(double decay, double turns, double lean)
{
    Oscillation result{.decay = static_cast<std::uint16_t>(std::lround(decay * decay_unit)),
                       .turns = static_cast<std::uint16_t>(std::lround(turns * turn_unit)),
                       .lean = static_cast<std::int16_t>(std::lround(lean * lean_unit))};
    result.size = static_cast<std::int16_t>(std::lround(size_for(result) * size_unit));
    return result;
}

/// In the order of SpringEnd.
constexpr std::array<std::string_view, 3> endings{"", "-in", "-in-out"};

std::string three_digits(double number)
{
    const double unit = std::pow(10, std::floor(std::log10(number)) - 2);
    return rounded_text(std::round(number / unit) * unit);
}

std::string physical_text(const Oscillation& numbers)
{
    const double decay = numbers.decay / decay_unit * std::numbers::ln2;
    const double speed = 2 * pi * numbers.turns / turn_unit;
    return '(' + three_digits(speed * speed + decay * decay) + ',' + three_digits(2 * decay) + ')';
}

}

double max_damping_of(double stiffness)
{
    return 2 * std::sqrt(stiffness) * steepest_lean / std::hypot(1, steepest_lean);
}

VelocityLaw mass_on_spring(double stiffness, double damping)
{
    const double decay = damping / 2;
    const double speed = std::sqrt(stiffness - decay * decay);
    return spring_law(oscillation(decay / std::numbers::ln2, speed / (2 * pi), decay / speed));
}

VelocityLaw elastic_law(double period, SpringEnd end)
{
    return spring_law(oscillation(elastic_decay, 1 / period, 0), end);
}

std::string spring_text(const VelocityLaw& law)
{
    const std::string ending{endings[static_cast<std::size_t>(end_of(law))]};
    if (law.kind == VelocityLaw::Kind::bounce)
        return "bounce" + ending + '(' + std::to_string(bounces_of(law)) + ')';
    const Oscillation numbers = oscillation_of(law);
    if (numbers.turns != 0 && numbers.lean == 0 && numbers.decay == elastic_decay * decay_unit)
        return "elastic" + ending + '(' + three_digits(turn_unit / numbers.turns) + ')';
    return "spring" + ending + (numbers.decay == 0 ? "" : physical_text(numbers));
}

}
