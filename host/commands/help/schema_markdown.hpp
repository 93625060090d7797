#pragma once

#include "host/scene/language_schema.hpp"

#include <string>

namespace kfast {

/// Two tables for docs/scene-language.md: all nodes, and all properties.
std::string schema_markdown(const scene::LanguageSchema& words);

}
