#pragma once

#include "host/fit/other_hardware.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace kfast::fit {

/// Small letters and digits alone: "Pico-2 W" is "pico2w".
inline std::string plain_name(std::string_view name)
{
    std::string plain;
    for (const char letter : name)
        if (std::isalnum(static_cast<unsigned char>(letter)) != 0)
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return plain;
}

inline bool is_called(const OtherName& other, std::string_view name)
{
    const std::string plain = ' ' + plain_name(name) + ' ';
    return plain.size() > 2 && (' ' + std::string{other.names} + ' ').find(plain) != std::string::npos;
}

}
