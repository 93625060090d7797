#pragma once

#include "host/kdl/document.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace kfast::schema {

class Variables;

/// Names of one kind, each of which may be given once.
class NameTable {
public:
    /// Adds a name; returns where it was given before, if it was.
    std::optional<SourceSpan> add(std::string_view name, SourceSpan place)
    {
        const auto [entry, fresh] = places_.try_emplace(std::string{name}, place);
        return fresh ? std::nullopt : std::optional{entry->second};
    }
    std::size_t size() const { return places_.size(); }

private:
    std::unordered_map<std::string, SourceSpan> places_;
};

/// The hint for a node that has no property `property`; `known` are those that it has.
using PropertyHint = std::string (*)(const kdl::Node& node, const kdl::Property& property,
                                     std::span<const std::string_view> known);

/// Passes on what is wrong with a text, up to a limit beyond which more is no help.
///
/// It is what every reader has, and so it has the variables of the text as well.
class Report {
public:
    /// `hint` is asked first for a hint about an unknown property; it may return an empty text.
    Report(const SourceText& source, Diagnostics& diagnostics, PropertyHint hint = nullptr)
        : source_{source}, diagnostics_{diagnostics}, property_hint_{hint}
    {
    }

    /// From here on, numbers of the text may be expressions with these, which must outlive it.
    void allow_expressions(Variables& variables) { variables_ = &variables; }
    /// Null where numbers are written as such.
    Variables* variables() const { return variables_; }

    /// Always false, so that a reader can return it.
    bool error(SourceSpan place, std::string message, std::string hint = {});
    void warning(SourceSpan place, std::string message, std::string hint = {});

    /// Errors are no longer passed on; reading may stop.
    bool full() const { return errors_ > max_errors; }
    std::string property_hint(const kdl::Node& node, const kdl::Property& property,
                              std::span<const std::string_view> known) const
    {
        return property_hint_ == nullptr ? std::string{} : property_hint_(node, property, known);
    }
    /// "line 12". Scans the text: only for messages.
    std::string line(SourceSpan place) const;

private:
    static constexpr std::size_t max_errors = 99; ///< with the last word, what is shown in full
    static constexpr std::size_t max_warnings = 99;

    const SourceText& source_;
    Diagnostics& diagnostics_;
    PropertyHint property_hint_;
    Variables* variables_ = nullptr;
    std::size_t errors_ = 0;
    std::size_t warnings_ = 0;
};

/// The report for the context that the rules of a table are read with; other readers have their own.
inline Report& report_of(Report& report) { return report; }

/// Whether `name` is new among `names`, those of the kind `noun`; reports it if not. `place` is marked.
bool add_name(NameTable& names, std::string_view noun, std::string_view name, SourceSpan place,
              Report& report);
/// Always false.
bool report_duplicate(std::string_view noun, std::string_view name, SourceSpan place, SourceSpan earlier,
                      Report& report);

/// From the start of `first` to the end of `last`.
constexpr SourceSpan span(SourceSpan first, SourceSpan last)
{
    return {first.offset, last.offset + last.length - first.offset};
}

}
