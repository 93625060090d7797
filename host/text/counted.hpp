#pragma once

#include <cstddef>
#include <string>

namespace kfast {

/// "1 frame", "2 frames"
inline std::string counted(std::size_t number, const std::string& noun)
{
    return std::to_string(number) + ' ' + noun + (number == 1 ? "" : "s");
}

}
