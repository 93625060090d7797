#include "host/text/diagnostic.hpp"

#include "host/text/characters.hpp"
#include "host/text/source.hpp"

#include <algorithm>
#include <utility>

namespace kfast {

namespace {

constexpr std::size_t gutter_digits = 4;

std::string headline(const Diagnostic& diagnostic, const SourceText& source, LineColumn at)
{
    return visible(source.name) + ':' + std::to_string(at.line) + ':' + std::to_string(at.column) +
           (diagnostic.severity == Severity::error ? ": error: " : ": warning: ") +
           visible(diagnostic.message) + '\n';
}

std::string right_aligned(const std::string& text, std::size_t width)
{
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

}

void Diagnostics::error(SourceSpan place, std::string message, std::string hint)
{
    entries_.push_back({Severity::error, place, std::move(message), std::move(hint)});
}

void Diagnostics::warning(SourceSpan place, std::string message, std::string hint)
{
    if (warned_.emplace(place.offset, message).second)
        entries_.push_back({Severity::warning, place, std::move(message), std::move(hint)});
}

bool Diagnostics::has_errors() const
{
    return std::ranges::any_of(entries_, [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::vector<Diagnostic> Diagnostics::sorted() const
{
    std::vector<Diagnostic> all = entries_;
    std::ranges::stable_sort(all, {}, [](const Diagnostic& d) { return d.place.offset; });
    return all;
}

namespace {

std::string format_at(LineColumn at, const Diagnostic& diagnostic, const SourceText& source)
{
    const auto [line, marks] = excerpt(source.text, diagnostic.place);
    const std::string number = std::to_string(at.line);
    const std::string gutter(std::max(gutter_digits, number.size()) + 1, ' ');
    std::string text = headline(diagnostic, source, at);
    text += right_aligned(number, gutter_digits) + " | " + line + '\n';
    text += gutter + "| " + marks + '\n';
    if (!diagnostic.hint.empty())
        text += gutter + "= help: " + visible(diagnostic.hint) + '\n';
    return text;
}

}

std::string format(const Diagnostic& diagnostic, const SourceText& source)
{
    return format_at(line_column(source.text, diagnostic.place.offset), diagnostic, source);
}

std::string format(const Diagnostic& diagnostic, const SourceText& source, const Places& places)
{
    return format_at(places.line_column(diagnostic.place.offset), diagnostic, source);
}

}
