#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

/// What expressions compute with. All of it is made of operations that IEEE 754 rounds in one way only, so
/// that every build computes the same: the functions of the C library differ in their last bits.
namespace kfast::schema {

struct Operator {
    char mark;
    int precedence; ///< the stronger one goes first
    double (*compute)(double left, double right);
};

inline constexpr std::array operators{
    Operator{'+', 1, [](double left, double right) { return left + right; }},
    Operator{'-', 1, [](double left, double right) { return left - right; }},
    Operator{'*', 2, [](double left, double right) { return left * right; }},
    Operator{'/', 2, [](double left, double right) { return left / right; }},
};

struct Function {
    std::string_view name;
    std::string_view usage; ///< "round(A)"
    std::size_t least;      ///< values
    std::size_t most;
    double (*compute)(std::span<const double> values);
};

/// sin, cos of degrees, within 1e-15.
double sine_of_degrees(double degrees);
double cosine_of_degrees(double degrees);
/// To the nearest whole number, halves away from zero.
double rounded(double number);
double min_of(std::span<const double> numbers);
double max_of(std::span<const double> numbers);

inline constexpr std::size_t any_count = std::numeric_limits<std::size_t>::max();

inline constexpr std::array functions{
    Function{"min", "min(A, B)", 2, any_count, min_of},
    Function{"max", "max(A, B)", 2, any_count, max_of},
    Function{"round", "round(A)", 1, 1, [](std::span<const double> values) { return rounded(values[0]); }},
    Function{"sin", "sin(DEGREES)", 1, 1,
             [](std::span<const double> values) { return sine_of_degrees(values[0]); }},
    Function{"cos", "cos(DEGREES)", 1, 1,
             [](std::span<const double> values) { return cosine_of_degrees(values[0]); }},
};

/// Null when there is no such function.
const Function* function_called(std::string_view name);

/// Rounded to nine decimals, halves away from zero, as far as a double has them: 0.1 * 3 is 0.3, and sin(30)
/// is 0.5.
double on_grid(double number);

}
