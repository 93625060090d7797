#pragma once

#include "host/text/source.hpp"

#include <filesystem>
#include <vector>

namespace kfast::scene {

/// The files of fonts that a scene text names, each once, whether they are there or not. Any text is allowed.
std::vector<std::filesystem::path> font_files(const SourceText& source);

}
