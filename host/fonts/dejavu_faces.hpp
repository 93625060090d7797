#pragma once

#include <string_view>

namespace kfast {

/// The faces of DejaVu that are part of this program. Each returns the bytes of a TrueType file, which are
/// valid as long as the program runs.
std::string_view dejavu_sans();
std::string_view dejavu_sans_bold();
std::string_view dejavu_sans_mono();

}
