#pragma once

#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <iostream>
#include <string>

namespace kfast {

struct DiagnosticCount {
    std::size_t errors = 0;
    std::size_t warnings = 0;
};

/// Prints all diagnostics to `out`, in the order of their places: in colour when that is standard error, a
/// terminal, and NO_COLOR is not set.
DiagnosticCount report(const Diagnostics& diagnostics, const SourceText& source,
                       std::ostream& out = std::cerr);

/// Prints "NAME: warning: TEXT", likewise.
void print_warning(const std::string& name, const std::string& text, std::ostream& out = std::cerr);

}
