#pragma once

#include "host/fit/target.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <optional>
#include <string_view>

namespace kfast::fit {

/// As a description of a board has it: "parallel-8"
std::string_view word_of(BusKind kind);

/// Reads the description of a board (docs/fit.md). Any text is allowed; what is wrong goes to `diagnostics`,
/// and there is a target exactly when nothing was.
std::optional<Target> read_board(const SourceText& source, Diagnostics& diagnostics);

}
