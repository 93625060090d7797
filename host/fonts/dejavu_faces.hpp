#pragma once

#include <string_view>

/// The DejaVu fonts that are part of this program, each a TrueType file.
namespace kfast {

std::string_view dejavu_sans();
std::string_view dejavu_sans_bold();
std::string_view dejavu_sans_mono();

}
