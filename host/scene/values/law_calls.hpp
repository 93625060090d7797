#pragma once

#include "core/time/velocity_law.hpp"
#include "host/scene/values/value_reader.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kfast::scene {

/// A number of a law.
struct Parameter {
    std::string_view name;
    Range range;
    std::optional<double> default_value = {}; ///< what it is in a law without parentheses
};

/// What is wrong with numbers that are in their ranges.
struct Objection {
    std::string message;
    std::string hint;
};

/// A law that has numbers in parentheses, or none where all of them have defaults.
struct CallForm {
    std::string_view keyword;
    std::span<const Parameter> parameters;
    bool whole_numbers;
    VelocityLaw (*make)(std::span<const double> numbers);
    std::optional<Objection> (*objection)(std::span<const double> numbers) = nullptr;

    /// Of all of its parameters.
    bool has_default_numbers() const { return parameters.front().default_value.has_value(); }
    /// Only if it has default numbers.
    VelocityLaw default_law() const;
};

/// `keyword` is that of a law with numbers (host/words/law_words.hpp).
const CallForm& call_of(std::string_view keyword);

}
