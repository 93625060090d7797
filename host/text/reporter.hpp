#pragma once

#include <cstddef>
#include <functional>

namespace kfast {

class Diagnostics;
struct SourceText;

struct DiagnosticCount {
    std::size_t errors = 0;
    std::size_t warnings = 0;
};

/// What is done with what the compiler finds in a text.
using Reporter = std::function<DiagnosticCount(const Diagnostics& diagnostics, const SourceText& source)>;

}
