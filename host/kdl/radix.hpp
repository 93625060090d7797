#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kfast::kdl {

/// The base in which a whole number is written: how it is introduced, and what its digits are.
class Radix {
public:
    static const Radix& decimal();
    /// Those that a number names by a prefix: hexadecimal, octal, binary.
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

}
