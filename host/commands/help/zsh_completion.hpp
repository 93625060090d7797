#pragma once

#include "host/commands/help/command_words.hpp"

#include <string>

namespace kfast {

/// A script for zsh that completes what `kfast` takes.
std::string zsh_completion(const CommandWords& kfast);

}
