#include "host/scene/context/symbol_table.hpp"

namespace kfast::scene {

std::optional<SourceSpan> SymbolTable::add(const SymbolEntry& entry)
{
    const auto [number, fresh] = numbers_.try_emplace(entry.name, entries.size());
    if (!fresh)
        return entries[number->second].place;
    entries.push_back(entry);
    return std::nullopt;
}

SymbolEntry* SymbolTable::find(std::string_view name)
{
    const auto number = numbers_.find(std::string{name});
    return number == numbers_.end() ? nullptr : &entries[number->second];
}

std::vector<std::string_view> SymbolTable::names() const
{
    std::vector<std::string_view> names;
    for (const SymbolEntry& entry : entries)
        names.push_back(entry.name);
    return names;
}

}
