#pragma once

#include "host/commands/help/command_words.hpp"

#include <string>

namespace kfast {

/// A script for bash that completes what `kfast` takes.
std::string bash_completion(const CommandWords& kfast);

/// A script for zsh that completes what `kfast` takes.
std::string zsh_completion(const CommandWords& kfast);

/// A script for fish that completes what `kfast` takes.
std::string fish_completion(const CommandWords& kfast);

}
