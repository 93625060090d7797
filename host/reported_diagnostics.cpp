#include "host/reported_diagnostics.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace kfast {
namespace {

bool colour_wanted() { return ::isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr; }

/// With the word "error:" or "warning:" of the first line in colour.
std::string coloured(std::string text, Severity severity)
{
    const std::string_view word = severity == Severity::error ? "error:" : "warning:";
    const std::size_t at = text.find(word);
    if (at == std::string::npos)
        return text;
    text.insert(at + word.size(), "\x1b[0m");
    return text.insert(at, severity == Severity::error ? "\x1b[1;31m" : "\x1b[1;35m");
}

}

DiagnosticCount count(const Diagnostics& diagnostics)
{
    const std::vector<Diagnostic> list = diagnostics.sorted();
    const auto errors =
        static_cast<std::size_t>(std::ranges::count(list, Severity::error, &Diagnostic::severity));
    return {errors, list.size() - errors};
}

DiagnosticCount report(const Diagnostics& diagnostics, const SourceText& source)
{
    const std::vector<Diagnostic> list = diagnostics.sorted();
    for (const Diagnostic& diagnostic : list) {
        const std::string text = format(diagnostic, source);
        std::cerr << (colour_wanted() ? coloured(text, diagnostic.severity) : text);
    }
    return count(diagnostics);
}

void print_warning(const std::string& name, const std::string& text)
{
    const std::string line = name + ": warning: " + text + '\n';
    std::cerr << (colour_wanted() ? coloured(line, Severity::warning) : line);
}

}
