#include "host/picture/format_name.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

constexpr std::array names{
    FormatName{"rgb565", PixelFormat::rgb565},
    FormatName{"grey4", PixelFormat::grey4},
    FormatName{"mono1", PixelFormat::mono1},
};

}

std::span<const FormatName> format_names() { return names; }

std::string_view name_of(PixelFormat format)
{
    return std::ranges::find(names, format, &FormatName::value)->name;
}

}
