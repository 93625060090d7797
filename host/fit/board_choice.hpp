#pragma once

#include "host/fit/target.hpp"

#include <string>

namespace kfast::fit {

/// The board that is called so, or that the file of this name describes: a name with a dot or a slash is that
/// of a file. What is wrong with a file is printed to standard error.
/// Throws Failure for a name that no board has and for a file that describes none.
Target chosen_board(const std::string& name);

}
