#pragma once

#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <functional>
#include <iostream>
#include <string>

namespace kfast {

class Diagnostics;
struct SourceText;

struct DiagnosticCount {
    std::size_t errors = 0;
    std::size_t warnings = 0;
};

/// What is done with what the compiler finds in a text.
using Reporter = std::function<DiagnosticCount(const Diagnostics& diagnostics, const SourceText& source)>;

DiagnosticCount count(const Diagnostics& diagnostics);

/// Prints diagnostics to `out`, in the order of their locations: in colour when that is standard error, a
/// terminal, and NO_COLOR is not set. Of more than 100 the last line says how many others there are; errors
/// rather than warnings are printed in full. Returns how many there are in all.
DiagnosticCount report(const Diagnostics& diagnostics, const SourceText& source,
                       std::ostream& out = std::cerr);

/// Returns a reporter that does this. `out` must outlive it.
Reporter printing_to(std::ostream& out);

/// Prints "NAME: warning: TEXT", coloured in the same way.
void print_warning(const std::string& name, const std::string& text, std::ostream& out = std::cerr);

}
