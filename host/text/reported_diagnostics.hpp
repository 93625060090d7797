#pragma once

#include "host/text/diagnostic.hpp"
#include "host/text/reporter.hpp"

#include <iostream>
#include <string>

namespace kfast {

DiagnosticCount count(const Diagnostics& diagnostics);

/// Prints all diagnostics to `out`, in the order of their places: in colour when that is standard error, a
/// terminal, and NO_COLOR is not set.
DiagnosticCount report(const Diagnostics& diagnostics, const SourceText& source,
                       std::ostream& out = std::cerr);

/// Reports so. `out` must outlive it.
Reporter printing_to(std::ostream& out);

/// Prints "NAME: warning: TEXT", likewise.
void print_warning(const std::string& name, const std::string& text, std::ostream& out = std::cerr);

}
