#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <string>

namespace kfast {

/// A validator of CLI11 for numbers within bounds. CLI::Range takes what is no number at all ("nan") for one
/// within them.
inline CLI::Validator number_within(double least, double most)
{
    const std::string bounds = CLI::detail::to_string(least) + " to " + CLI::detail::to_string(most);
    const auto mistake = [=](const std::string& text) {
        double value = 0;
        const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_number = error == std::errc{} && rest == text.data() + text.size();
        return is_number && value >= least && value <= most ? ""
                                                            : "'" + text + "' is not a number from " + bounds;
    };
    return {mistake, "NUMBER from " + bounds};
}

}
