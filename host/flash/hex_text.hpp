#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

namespace kfast {

/// "0x10001000", with more digits where eight are too few.
inline std::string hex_text(std::uint64_t value)
{
    std::array<char, 20> text{};
    std::snprintf(text.data(), text.size(), "0x%08llx", static_cast<unsigned long long>(value));
    return text.data();
}

}
