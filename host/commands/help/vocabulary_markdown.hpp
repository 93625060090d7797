#pragma once

#include "host/scene/vocabulary.hpp"

#include <string>

namespace kfast {

/// Two tables for docs/scene-language.md: all nodes, and all properties.
std::string vocabulary_markdown(const scene::Vocabulary& words);

}
