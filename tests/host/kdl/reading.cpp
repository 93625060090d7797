#include "tests/host/kdl/reading.hpp"

#include "host/kdl/canonical.hpp"
#include "host/kdl/parser.hpp"

namespace kfast::test {

namespace {

std::string listed(const Diagnostics& diagnostics, std::string_view text)
{
    std::string list;
    for (const Diagnostic& diagnostic : diagnostics.sorted()) {
        const LineColumn at = line_column(text, diagnostic.place.offset);
        list += std::to_string(at.line) + ':' + std::to_string(at.column) + ": " + diagnostic.message + '\n';
    }
    return list;
}

}

std::string reading(std::string_view text)
{
    Diagnostics diagnostics;
    const kdl::Document document = kdl::parse(text, diagnostics);
    return diagnostics.has_errors() ? listed(diagnostics, text) : kdl::canonical(document);
}

std::string errors(std::string_view text)
{
    Diagnostics diagnostics;
    kdl::parse(text, diagnostics);
    return listed(diagnostics, text);
}

std::string hint(std::string_view text)
{
    Diagnostics diagnostics;
    kdl::parse(text, diagnostics);
    const auto found = diagnostics.sorted();
    return found.empty() ? "nothing is found" : found.front().hint;
}

}
