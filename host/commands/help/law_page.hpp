#pragma once

#include "host/commands/help/help_page.hpp"

#include <string>

namespace kfast {

/// What 'kfast help laws' prints: all velocity laws with their curves, and the names of other programs.
std::string law_page(const HelpStyle& style);

}
