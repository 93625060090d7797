#include "host/kdl/number.hpp"

#include "host/text/characters.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace kfast::kdl {

namespace {

/// The base in which a whole number is written: how it is introduced, and what its digits are.
class Radix {
public:
    static const Radix& decimal();
    /// Those that a prefix of a number selects: hexadecimal, octal, binary.
    static std::span<const Radix> prefixed();

    std::string_view prefix() const { return prefix_; } ///< "0x"
    std::string_view name() const { return name_; }     ///< "a hexadecimal number"
    std::string_view rule() const { return rule_; }     ///< "after 0x come the digits 0 to 9 and a to f"

    bool has_digit(char character) const;
    /// `digits` must be digits of this radix, at least one.
    std::string in_decimal(std::string_view digits) const;

private:
    constexpr Radix(unsigned base, std::string_view prefix, std::string_view name, std::string_view rule)
        : base_(base), prefix_(prefix), name_(name), rule_(rule)
    {
    }

    unsigned base_;
    std::string_view prefix_;
    std::string_view name_;
    std::string_view rule_;
};

constexpr std::uint64_t limb_base = 1'000'000'000;
constexpr std::size_t limb_digits = 9;

constexpr unsigned no_digit = 99;

unsigned digit_value(char character)
{
    if (character >= '0' && character <= '9')
        return static_cast<unsigned>(character - '0');
    if (character >= 'a' && character <= 'f')
        return static_cast<unsigned>(character - 'a') + 10;
    if (character >= 'A' && character <= 'F')
        return static_cast<unsigned>(character - 'A') + 10;
    return no_digit;
}

/// `limbs`, lowest first, become limbs * factor + addend.
void multiply_add(std::vector<std::uint64_t>& limbs, unsigned factor, unsigned addend)
{
    std::uint64_t carry = addend;
    for (std::uint64_t& limb : limbs) {
        carry += limb * factor;
        limb = carry % limb_base;
        carry /= limb_base;
    }
    if (carry > 0)
        limbs.push_back(carry);
}

const Radix& Radix::decimal()
{
    static constexpr Radix radix{10, "", "a decimal number", "use the digits 0 to 9"};
    return radix;
}

std::span<const Radix> Radix::prefixed()
{
    static constexpr std::array radices{
        Radix{16, "0x", "a hexadecimal number", "after 0x come the digits 0 to 9 and a to f"},
        Radix{8, "0o", "an octal number", "after 0o come the digits 0 to 7"},
        Radix{2, "0b", "a binary number", "after 0b come the digits 0 and 1"},
    };
    return radices;
}

bool Radix::has_digit(char character) const { return digit_value(character) < base_; }

std::string Radix::in_decimal(std::string_view digits) const
{
    std::vector<std::uint64_t> limbs{0};
    for (const char digit : digits)
        multiply_add(limbs, base_, digit_value(digit));
    std::string text = std::to_string(limbs.back());
    for (auto limb = limbs.rbegin() + 1; limb != limbs.rend(); ++limb) {
        const std::string low = std::to_string(*limb);
        text += std::string(limb_digits - low.size(), '0') + low;
    }
    return text;
}

/// The parts of a decimal number, their digits as canonical form writes them; the last two may be absent.
struct Decimal {
    bool is_negative = false;
    std::string integer = {};
    std::string fraction = {};
    bool is_exponent_negative = false;
    std::string exponent = {};
};

std::string without_leading_zeros(std::string digits)
{
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
    return digits;
}

/// Takes a digit and the digits and underscores after it; empty if there is no digit.
std::string take_digits(std::string_view& rest, const Radix& radix)
{
    if (rest.empty() || !radix.has_digit(rest.front()))
        return {};
    std::string digits;
    while (!rest.empty() && (rest.front() == '_' || radix.has_digit(rest.front()))) {
        if (rest.front() != '_')
            digits += rest.front();
        rest.remove_prefix(1);
    }
    return digits;
}

bool take(std::string_view& rest, std::string_view expected)
{
    if (!rest.starts_with(expected))
        return false;
    rest.remove_prefix(expected.size());
    return true;
}

/// Takes a sign, if there is one. Returns whether it was a minus.
bool take_sign(std::string_view& rest)
{
    const bool is_negative = take(rest, "-");
    if (!is_negative)
        take(rest, "+");
    return is_negative;
}

/// The position of the first significant digit, as a power of ten; it decides only whether a number that is
/// out of the range of double is too great or too small.
double magnitude(const Decimal& decimal)
{
    const std::string digits = decimal.integer + decimal.fraction;
    const std::size_t zeros = std::min(digits.find_first_not_of('0'), digits.size());
    double exponent = 0; // digits beyond 18 leave no doubt either
    for (const char digit : std::string_view{decimal.exponent}.substr(0, 18))
        exponent = exponent * 10 + (digit - '0');
    return static_cast<double>(decimal.integer.size()) - static_cast<double>(zeros) +
           (decimal.is_exponent_negative ? -exponent : exponent);
}

double nearest_double(const std::string& canonical, const Decimal& decimal)
{
    double value = 0;
    const auto [end, fault] = std::from_chars(canonical.data(), canonical.data() + canonical.size(), value);
    if (fault == std::errc::result_out_of_range) {
        value = magnitude(decimal) > 0 ? std::numeric_limits<double>::infinity() : 0;
        return decimal.is_negative ? -value : value;
    }
    return value;
}

Number number_of(const Decimal& decimal)
{
    std::string canonical = (decimal.is_negative ? "-" : "") + decimal.integer;
    if (!decimal.fraction.empty())
        canonical.append(".").append(decimal.fraction);
    if (!decimal.exponent.empty())
        canonical.append(decimal.is_exponent_negative ? "E-" : "E+").append(decimal.exponent);
    const double value = nearest_double(canonical, decimal);
    return {.canonical = std::move(canonical), .value = value};
}

/// The hint depends on what follows the digits.
std::string hint_of(std::string_view word)
{
    std::string_view behind = word;
    take_sign(behind);
    take_digits(behind, Radix::decimal());
    const bool is_whole = !take(behind, ".");
    if (!is_whole)
        take_digits(behind, Radix::decimal());
    const std::string number{word.substr(0, word.size() - behind.size())};
    if (behind == "s" || behind == "ms")
        return "write (" + std::string{behind} + ')' + number + ": a unit stands before its number";
    if (behind == "%")
        return "write the share, like 0.5 for 50%";
    if (!take(behind, ","))
        return (behind.find_first_of(".0123456789") == behind.npos ? "write " + number + " alone, or " : "") +
               "put a text that begins with a digit in quotes";
    const std::string more = take_digits(behind, Radix::decimal());
    if (!is_whole || more.empty() || !behind.empty())
        return "separate values by spaces alone, without commas";
    return "write " + number + '.' + more + " for a fraction, " + number + ' ' + more + " for two numbers";
}

NumberFault not_a_number(std::string_view word)
{
    return {.message = in_quotes(word) + " begins like a number but is none", .hint = hint_of(word)};
}

std::variant<Number, NumberFault> integer_of(const Radix& radix, std::string_view word, std::string_view rest)
{
    constexpr std::size_t max_digits = 1000;
    const std::string digits = take_digits(rest, radix);
    if (digits.empty() || !rest.empty())
        return NumberFault{.message = in_quotes(word) + " is not " + std::string(radix.name()),
                           .hint = std::string(radix.rule()) + "; a _ may stand after a digit"};
    const std::string significant = without_leading_zeros(digits);
    if (significant.size() > max_digits)
        return NumberFault{.message = "this number has more than 1000 digits", .hint = "write it in decimal"};
    return number_of({.is_negative = word.front() == '-', .integer = radix.in_decimal(significant)});
}

std::variant<Number, NumberFault> decimal_of(std::string_view word, std::string_view rest)
{
    Decimal decimal{.is_negative = word.front() == '-'};
    if (rest.starts_with('.'))
        return NumberFault{.message = "a number cannot begin with its point",
                           .hint = "write a 0 before the point"};
    decimal.integer = without_leading_zeros(take_digits(rest, Radix::decimal()));
    if (take(rest, ".") && (decimal.fraction = take_digits(rest, Radix::decimal())).empty())
        return NumberFault{.message = "no digit follows the point of this number",
                           .hint = "write a 0 after the point or leave the point out"};
    if (take(rest, "e") || take(rest, "E")) {
        decimal.is_exponent_negative = take_sign(rest);
        decimal.exponent = without_leading_zeros(take_digits(rest, Radix::decimal()));
        if (decimal.exponent.empty() && rest.empty())
            return NumberFault{.message = "no digit follows the e of this number",
                               .hint = "write a whole exponent, as in 1e3 or 1e-3"};
    }
    if (!rest.empty())
        return not_a_number(word);
    return number_of(decimal);
}

}

std::variant<Number, NumberFault> number_from(std::string_view word)
{
    std::string_view rest = word;
    take_sign(rest);
    for (const Radix& radix : Radix::prefixed())
        if (take(rest, radix.prefix()))
            return integer_of(radix, word, rest);
    return decimal_of(word, rest);
}

}
