#include "host/text/reported_diagnostics.hpp"

#include "host/text/characters.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/number_text.hpp"
#include "host/text/source.hpp"
#include "host/text/visible_output.hpp"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace kfast {

namespace {

/// What is more helps nobody who reads.
constexpr std::size_t most_in_full = 100;

bool colour_wanted(const std::ostream& out)
{
    return &out == &std::cerr && ::isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
}

/// With the word "error:" or "warning:" of the first line in colour.
void print_coloured(std::string_view text, Severity severity, std::ostream& out)
{
    const std::string_view word = severity == Severity::error ? "error:" : "warning:";
    const std::size_t at = text.find(word);
    if (at == std::string_view::npos) {
        out << text;
        return;
    }
    out << text.substr(0, at);
    write_as_is(out, severity == Severity::error ? "\x1b[1;31m" : "\x1b[1;35m");
    out << word;
    write_as_is(out, "\x1b[0m");
    out << text.substr(at + word.size());
}

void print(std::string_view text, Severity severity, std::ostream& out)
{
    if (colour_wanted(out))
        print_coloured(text, severity, out);
    else
        out << text;
}

}

namespace {

DiagnosticCount count_of(std::span<const Diagnostic> list)
{
    const auto errors =
        static_cast<std::size_t>(std::ranges::count(list, Severity::error, &Diagnostic::severity));
    return {errors, list.size() - errors};
}

/// Those of `sorted` that are shown in full, in its order: errors rather than warnings, early ones rather
/// than late ones.
std::vector<Diagnostic> most_important(const std::vector<Diagnostic>& sorted)
{
    const std::size_t errors = std::min(count_of(sorted).errors, most_in_full);
    DiagnosticCount left{errors, most_in_full - errors};
    std::vector<Diagnostic> chosen;
    for (const Diagnostic& diagnostic : sorted) {
        std::size_t& room = diagnostic.severity == Severity::error ? left.errors : left.warnings;
        if (room == 0)
            continue;
        --room;
        chosen.push_back(diagnostic);
    }
    return chosen;
}

/// "3 errors and 1 warning"
std::string count_text(DiagnosticCount number)
{
    if (number.errors == 0)
        return counted(number.warnings, "warning");
    const std::string errors = counted(number.errors, "error");
    return number.warnings == 0 ? errors : errors + " and " + counted(number.warnings, "warning");
}

}

DiagnosticCount count(const Diagnostics& diagnostics) { return count_of(diagnostics.in_order_found()); }

DiagnosticCount report(const Diagnostics& diagnostics, const SourceText& source, std::ostream& out)
{
    const DiagnosticCount all = count(diagnostics);
    if (all.errors + all.warnings == 0)
        return all;
    const std::vector<Diagnostic> shown = most_important(diagnostics.sorted());
    const Places places{source.text};
    for (const Diagnostic& diagnostic : shown)
        print(format(diagnostic, source, places), diagnostic.severity, out);
    const DiagnosticCount in_full = count_of(shown);
    const DiagnosticCount more{all.errors - in_full.errors, all.warnings - in_full.warnings};
    if (more.errors + more.warnings > 0)
        out << visible(source.name) << ": ... and " << count_text(more) << " more\n";
    return all;
}

Reporter printing_to(std::ostream& out)
{
    return [&out](const Diagnostics& diagnostics, const SourceText& source) {
        return report(diagnostics, source, out);
    };
}

void print_warning(const std::string& name, const std::string& text, std::ostream& out)
{
    print(name + ": warning: " + text + '\n', Severity::warning, out);
}

}
