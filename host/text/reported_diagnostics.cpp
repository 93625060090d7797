#include "host/text/reported_diagnostics.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <unistd.h>

namespace kfast {

namespace {

bool colour_wanted(const std::ostream& out)
{
    return &out == &std::cerr && ::isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
}

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

DiagnosticCount report(const Diagnostics& diagnostics, const SourceText& source, std::ostream& out)
{
    const std::vector<Diagnostic> list = diagnostics.sorted();
    for (const Diagnostic& diagnostic : list) {
        const std::string text = format(diagnostic, source);
        out << (colour_wanted(out) ? coloured(text, diagnostic.severity) : text);
    }
    return count(diagnostics);
}

Reporter printing_to(std::ostream& out)
{
    return [&out](const Diagnostics& diagnostics, const SourceText& source) {
        return report(diagnostics, source, out);
    };
}

void print_warning(const std::string& name, const std::string& text, std::ostream& out)
{
    const std::string line = name + ": warning: " + text + '\n';
    out << (colour_wanted(out) ? coloured(line, Severity::warning) : line);
}

}
