#include "host/kdl/radix.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace kfast::kdl {

namespace {

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

}
