#pragma once

#include "core/pixel/pixel_format.hpp"

#include <span>
#include <string_view>

namespace kfast {

/// What a format of pixels is called on the command line and in descriptions of boards.
struct FormatName {
    std::string_view name;
    PixelFormat value;
};

std::span<const FormatName> format_names();
std::string_view name_of(PixelFormat format);

}
