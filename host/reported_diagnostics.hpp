#pragma once

#include "host/text/diagnostic.hpp"

#include <cstddef>

namespace kfast {

struct DiagnosticCount {
    std::size_t errors = 0;
    std::size_t warnings = 0;
};

/// Prints all diagnostics to standard error, in the order of their places: in colour when that is a terminal
/// and NO_COLOR is not set.
DiagnosticCount report(const Diagnostics& diagnostics, const SourceText& source);

}
