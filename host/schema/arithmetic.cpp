#include "host/schema/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kfast::schema {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

/// 1 - square / (n (n + 1)) * (1 - square / ((n + 2) (n + 3)) * …): of a sine from n = 2 on, and times the
/// angle; of a cosine from n = 1 on. Eight steps are enough for an eighth of a turn.
double series(double square, int first)
{
    double sum = 1;
    for (int n = first + 14; n >= first; n -= 2)
        sum = 1 - square / (n * (n + 1)) * sum;
    return sum;
}

double small_sine(double degrees)
{
    const double angle = degrees * radians_per_degree;
    return angle * series(angle * angle, 2);
}

double small_cosine(double degrees)
{
    const double angle = degrees * radians_per_degree;
    return series(angle * angle, 1);
}

/// Of 0 to 90 degrees. The differences here and below are exact.
double quarter_sine(double degrees)
{
    return degrees <= 45 ? small_sine(degrees) : small_cosine(90 - degrees);
}
double quarter_cosine(double degrees)
{
    return degrees <= 45 ? small_cosine(degrees) : small_sine(90 - degrees);
}

}

double sine_of_degrees(double degrees)
{
    const double part = std::fmod(std::abs(degrees), 360);
    const double half = part >= 180 ? part - 180 : part;
    const double sine = quarter_sine(half > 90 ? 180 - half : half);
    return (degrees < 0) == (part >= 180) ? sine : -sine;
}

double cosine_of_degrees(double degrees)
{
    const double part = std::fmod(std::abs(degrees), 360);
    const double half = part > 180 ? 360 - part : part;
    return half > 90 ? -quarter_cosine(180 - half) : quarter_cosine(half);
}

double rounded(double number) { return std::round(number); }

double min_of(std::span<const double> numbers) { return *std::ranges::min_element(numbers); }

double max_of(std::span<const double> numbers) { return *std::ranges::max_element(numbers); }

const Function* function_called(std::string_view name)
{
    const auto function = std::ranges::find(functions, name, &Function::name);
    return function == functions.end() ? nullptr : &*function;
}

double on_grid(double number)
{
    constexpr double parts = 1e9;
    constexpr double finer = 4194304; // from here on neighbours lie about as far apart as the grid
    if (std::abs(number) >= finer)
        return number;
    return std::round(number * parts) / parts + 0.0; // which makes 0 of -0
}

}
