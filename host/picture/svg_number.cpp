#include "host/picture/svg_number.hpp"

#include <cstdint>
#include <cstdlib>

namespace kfast {
namespace {

constexpr std::int64_t parts = 10'000;

/// "1.25" for 12500
std::string decimal(std::int64_t count)
{
    std::string digits = std::to_string(std::abs(count) % parts + parts).substr(1);
    digits.erase(digits.find_last_not_of('0') + 1);
    const std::string whole = std::to_string(std::abs(count) / parts);
    return (count < 0 ? "-" : "") + whole + (digits.empty() ? "" : "." + digits);
}

}

std::string svg_number(Fixed length)
{
    const std::int64_t raw = length.raw();
    const std::int64_t scaled = std::abs(raw) * parts + Fixed::one / 2;
    const std::int64_t count = scaled / Fixed::one;
    return decimal(raw < 0 ? -count : count);
}

std::string svg_share(std::uint32_t opacity) { return decimal((opacity * parts + 127) / 255); }

}
