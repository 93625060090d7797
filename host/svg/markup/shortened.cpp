#include "host/svg/markup/shortened.hpp"

namespace kfast::svg {

std::string shortened(std::string_view text, std::size_t max)
{
    if (text.size() <= max)
        return std::string{text};
    std::size_t end = max;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
        --end;
    return std::string{text.substr(0, end)} + "...";
}

}
