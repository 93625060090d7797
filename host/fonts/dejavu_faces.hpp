#pragma once

#include <string_view>

namespace kfast {

/// DejaVu Sans Mono, a TrueType file.
std::string_view screen_font_bytes();

}
