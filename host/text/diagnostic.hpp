#pragma once

#include "host/text/source.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

enum class Severity { warning, error };

/// One thing that is wrong with a text: where, what, and what would be valid.
struct Diagnostic {
    Severity severity = Severity::error;
    SourceSpan place;
    std::string message; ///< what is wrong: "unknown colour \"blu\""
    std::string hint;    ///< what would be valid: "did you mean \"blue\"?"; may be empty
};

/// Collects what is wrong, so that one run reports all of it.
class Diagnostics {
public:
    void error(SourceSpan place, std::string message, std::string hint = {});
    /// The same warning at the same place, as for each copy of a symbol, is reported once.
    void warning(SourceSpan place, std::string message, std::string hint = {});

    bool has_errors() const;
    const std::vector<Diagnostic>& in_order_found() const { return entries_; }
    /// In the order of their locations.
    std::vector<Diagnostic> sorted() const;

private:
    std::vector<Diagnostic> entries_;
    std::set<std::pair<std::size_t, std::string>> warned_; ///< where, and of what
};

/// One diagnostic for a terminal: `name:line:column: error: message`, the line itself, a caret under the
/// location, and the hint. Long lines are cut around it; control characters are made visible.
std::string format(const Diagnostic& diagnostic, const SourceText& source);
/// The same for one of many; `places` are those of the text.
std::string format(const Diagnostic& diagnostic, const SourceText& source, const Places& places);

}
