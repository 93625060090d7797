#pragma once

#include "host/reporter.hpp"
#include "host/text/diagnostic.hpp"

#include <string>

namespace kfast {

DiagnosticCount count(const Diagnostics& diagnostics);

/// Prints all diagnostics to standard error, in the order of their places: in colour when that is a terminal
/// and NO_COLOR is not set.
DiagnosticCount report(const Diagnostics& diagnostics, const SourceText& source);

/// Prints "NAME: warning: TEXT" to standard error, likewise.
void print_warning(const std::string& name, const std::string& text);

}
