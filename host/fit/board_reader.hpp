#pragma once

#include "host/fit/target.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <optional>
#include <string_view>

namespace kfast::fit {

/// As in a description of a board: "parallel-8"
std::string_view word_of(BusKind kind);

/// Reads the description of a board (docs/fit.md). Any text is allowed; mistakes are reported to
/// `diagnostics`, and there is a target exactly when there are none.
std::optional<Target> read_board(const SourceText& source, Diagnostics& diagnostics);

}
