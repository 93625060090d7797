#include "host/scene/context/tables.hpp"

#include <algorithm>

namespace kfast::scene {

namespace {

std::string_view name_of(const Skeleton& skeleton) { return skeleton.bones.name; }

template <class Things, class NameOf>
std::optional<std::size_t> index_of(const Things& things, std::string_view name, NameOf name_of)
{
    const auto found = std::ranges::find(things, name, name_of);
    if (found == things.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - things.begin());
}

}

std::optional<std::size_t> find_bone(const std::vector<Bone>& bones, std::string_view name)
{
    return index_of(bones, name, &Bone::name);
}

std::vector<std::string_view> names_of(const std::vector<Bone>& bones)
{
    std::vector<std::string_view> names(bones.size());
    std::ranges::transform(bones, names.begin(), &Bone::name);
    return names;
}

std::optional<std::size_t> SkeletonTable::find(std::string_view name) const
{
    return index_of(entries, name, name_of);
}

std::vector<std::string_view> SkeletonTable::names() const
{
    std::vector<std::string_view> names(entries.size());
    std::ranges::transform(entries, names.begin(), name_of);
    return names;
}

std::size_t SkeletonTable::bone_count() const
{
    std::size_t count = 0;
    for (const Skeleton& skeleton : entries)
        count += skeleton.bones.bones.size();
    return count;
}

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
