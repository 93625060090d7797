#pragma once

#include "host/text/source.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace kfast::schema {

/// Names of one kind, each of which may be given once.
class NameTable {
public:
    /// Where the name was given before, if it was.
    std::optional<SourceSpan> add(std::string_view name, SourceSpan place)
    {
        const auto [entry, fresh] = places_.try_emplace(std::string{name}, place);
        return fresh ? std::nullopt : std::optional{entry->second};
    }
    std::size_t size() const { return places_.size(); }

private:
    std::unordered_map<std::string, SourceSpan> places_;
};

}
