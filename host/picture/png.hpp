#pragma once

#include "host/picture/picture.hpp"

#include <filesystem>

namespace kfast {

/// Throws Failure when the file cannot be written; then there is none.
void write_png(const std::filesystem::path& target, const Picture& picture);

}
