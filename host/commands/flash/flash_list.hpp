#pragma once

#include "host/commands/flash/flash_environment.hpp"

namespace kfast {

enum class ListForm { text, json };

/// Prints all boards that could be flashed: those in their boot loaders, those that run KFAST, and drives.
/// Throws Failure with no_device if there are none.
void print_flash_list(FlashEnvironment& environment, ListForm form);

}
