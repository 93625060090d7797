#include "host/kdl/scanner.hpp"

#include "host/kdl/code_point_class.hpp"
#include "host/text/utf8.hpp"

#include <algorithm>
#include <utility>

namespace kfast::kdl {

namespace {

constexpr int max_errors = 20;

}

bool Scanner::at_newline() const { return is_newline(peek()); }

bool Scanner::at_space() const { return is_space(peek()); }

char32_t Scanner::peek() const { return at_end() ? end_of_text : code_point_at(text_, offset_).value; }

void Scanner::advance() { offset_ += code_point_at(text_, offset_).length; }

bool Scanner::accept(std::string_view expected)
{
    if (!at(expected))
        return false;
    offset_ += expected.size();
    return true;
}

bool Scanner::accept_newline()
{
    if (accept("\r\n"))
        return true;
    if (!at_newline())
        return false;
    advance();
    return true;
}

void Scanner::error(SourceSpan place, std::string message, std::string hint)
{
    if (silent_ || stopped_)
        return;
    silent_ = true;
    if (errors_ < max_errors)
        return report(place, std::move(message), std::move(hint));
    report({.offset = last_error_, .length = 0},
           "there are more than " + std::to_string(max_errors) + " errors; the rest is not shown", {});
    stop();
}

void Scanner::warning(SourceSpan place, std::string message, std::string hint)
{
    diagnostics_.warning(place, std::move(message), std::move(hint));
}

bool Scanner::silence(bool silent) { return std::exchange(silent_, silent); }

void Scanner::stop()
{
    offset_ = text_.size();
    stopped_ = true;
}

void Scanner::report(SourceSpan place, std::string message, std::string hint)
{
    ++errors_;
    last_error_ = std::max(last_error_, place.offset);
    diagnostics_.error(place, std::move(message), std::move(hint));
}

}
