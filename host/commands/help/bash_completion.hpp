#pragma once

#include "host/commands/help/command_words.hpp"

#include <string>

namespace kfast {

/// A script for bash that completes what `kfast` takes.
std::string bash_completion(const CommandWords& kfast);

}
