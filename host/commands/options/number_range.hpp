#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <iterator>
#include <string>

namespace kfast {

/// A validator of CLI11 for numbers within bounds, which it describes as "0.1 to 3600". CLI::Range takes what
/// is no number at all ("nan") for one within them.
inline CLI::Validator number_within(double min, double max)
{
    const auto written = [](double bound) {
        char digits[32];
        return std::string{digits,
                           std::to_chars(digits, std::end(digits), bound, std::chars_format::fixed).ptr};
    };
    const std::string bounds = written(min) + " to " + written(max);
    const auto mistake = [=](const std::string& text) {
        double value = 0;
        const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_number = error == std::errc{} && rest == text.data() + text.size();
        return is_number && value >= min && value <= max ? ""
                                                         : "'" + text + "' is not a number from " + bounds;
    };
    return {mistake, bounds};
}

}
