#pragma once

#include "host/commands/help/command_words.hpp"
#include "host/scene/language_schema.hpp"

#include <string>
#include <vector>

namespace kfast {

struct ManPage {
    std::string file; ///< "kfast-render.1"
    std::string text;
};

/// kfast(1), a page for each command, and kfast-scene(5).
std::vector<ManPage> man_pages(const CommandWords& kfast, const scene::LanguageSchema& words);

}
