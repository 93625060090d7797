#pragma once

#include "host/schema/variables.hpp"
#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Arithmetic in the place of a number: "2 * (size + 4)". docs/scene-language.md has the rules.
namespace kfast::schema {

inline constexpr std::size_t longest_expression = 1000; ///< bytes
inline constexpr int deepest_expression = 32;           ///< parentheses, functions and signs in each other
/// The limit of every number on the way, either sign. So none is ever infinite, or no number at all.
inline constexpr double largest_number = 1e9;

/// What an expression comes to. With neither value nor finding, it needs a variable that is wrong, which has
/// been reported.
struct Evaluation {
    std::optional<double> value = {};
    std::optional<Diagnostic> finding = {}; ///< its place counts from the beginning of the text
    const Variable* too_early = nullptr;    ///< the finding is that this one is not yet defined
    std::size_t end = 0;                    ///< how far the text has been read
};

/// The value of the whole text, rounded to nine decimals; a = may stand in front. Variables that it has are
/// used.
Evaluation evaluate(std::string_view text, Variables& variables);

/// The same for the longest expression that begins at `begin`, whatever follows it.
Evaluation evaluate_front(std::string_view text, std::size_t begin, Variables& variables);

}
