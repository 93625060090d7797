#include "host/scene/values/law_calls.hpp"

#include "core/time/spring_law.hpp"
#include "host/words/law_words.hpp"
#include "host/words/spring_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace kfast::scene {

namespace {

using Numbers = std::span<const double>;

constexpr Range control_x{0, 1};
constexpr Range control_y{double{VelocityLaw::lowest_y} / VelocityLaw::control_one,
                          double{VelocityLaw::highest_y} / VelocityLaw::control_one};
constexpr Range period{spring_limits::min_period, spring_limits::max_period};

constexpr std::array step_parameters{Parameter{"n", {1, std::numeric_limits<std::uint16_t>::max()}}};
constexpr std::array bezier_parameters{Parameter{"x1", control_x}, Parameter{"y1", control_y},
                                       Parameter{"x2", control_x}, Parameter{"y2", control_y}};
constexpr std::array back_parameters{Parameter{"s", {0, 6}, 1.70158}};
constexpr std::array bounce_parameters{Parameter{"n", {1, spring_count::max_bounces}, 3}};
constexpr std::array elastic_parameters{Parameter{"period", period, 0.3}};
constexpr std::array slow_elastic_parameters{Parameter{"period", period, 0.45}};
constexpr std::array spring_parameters{
    Parameter{"stiffness", {spring_limits::min_stiffness, spring_limits::max_stiffness}, 100},
    Parameter{"damping", {spring_limits::min_damping, spring_limits::max_damping}, 10}};

// (s + 1) u^3 - s u^2 from the earlier key: x is u itself with its control points at thirds.
VelocityLaw back(Numbers s) { return bezier_law(1.0 / 3, 1 + s[0] / 3, 2.0 / 3, 1); }
VelocityLaw back_in(Numbers s) { return bezier_law(1.0 / 3, 0, 2.0 / 3, -s[0] / 3); }

template <SpringEnd end>
VelocityLaw bounce(Numbers n)
{
    return bounce_law(static_cast<std::uint32_t>(n[0]), end);
}

template <SpringEnd end>
VelocityLaw elastic(Numbers numbers)
{
    return elastic_law(numbers[0], end);
}

std::optional<Objection> objection_to_spring(Numbers numbers)
{
    const double max = max_damping_of(numbers[0]);
    if (numbers[1] <= max)
        return std::nullopt;
    return Objection{"a spring of stiffness " + text_of(numbers[0]) + " does not swing with a damping of " +
                         text_of(numbers[1]),
                     "take a damping of at most " + text_of(std::floor(max * 10) / 10) +
                         ", or the law \"decelerate\""};
}

constexpr std::array calls{
    CallForm{"steps", step_parameters, true,
             [](Numbers n) { return VelocityLaw::in_steps(static_cast<std::uint16_t>(n[0])); }},
    CallForm{"bezier", bezier_parameters, false,
             [](Numbers n) { return bezier_law(n[0], n[1], n[2], n[3]); }},
    CallForm{"back", back_parameters, false, back},
    CallForm{"back-in", back_parameters, false, back_in},
    CallForm{"spring", spring_parameters, false, [](Numbers n) { return mass_on_spring(n[0], n[1]); },
             objection_to_spring},
    CallForm{"elastic", elastic_parameters, false, elastic<SpringEnd::next>},
    CallForm{"elastic-in", elastic_parameters, false, elastic<SpringEnd::earlier>},
    CallForm{"elastic-in-out", slow_elastic_parameters, false, elastic<SpringEnd::both>},
    CallForm{"bounce", bounce_parameters, true, bounce<SpringEnd::next>},
    CallForm{"bounce-in", bounce_parameters, true, bounce<SpringEnd::earlier>},
    CallForm{"bounce-in-out", bounce_parameters, true, bounce<SpringEnd::both>},
};

static_assert(std::ranges::all_of(law_words, [](const LawWord& word) {
    return word.has_numbers() == (std::ranges::find(calls, word.keyword, &CallForm::keyword) != calls.end());
}));

}

VelocityLaw CallForm::default_law() const
{
    std::vector<double> numbers;
    for (const Parameter& parameter : parameters)
        numbers.push_back(parameter.default_value.value());
    return make(numbers);
}

const CallForm& call_of(std::string_view keyword)
{
    return *std::ranges::find(calls, keyword, &CallForm::keyword);
}

}
