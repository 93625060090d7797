#include "host/schema/variables.hpp"

#include "host/schema/expression.hpp"
#include "host/schema/variable_names.hpp"

#include <algorithm>
#include <utility>

namespace kfast::schema {

const Variable* Variables::add(Variable variable)
{
    const auto [number, fresh] = numbers_.try_emplace(variable.name, all_.size());
    if (!fresh)
        return &all_[number->second];
    all_.push_back(std::move(variable));
    return nullptr;
}

Variable* Variables::find(std::string_view name)
{
    const auto number = numbers_.find(std::string{name});
    return number == numbers_.end() ? nullptr : &all_[number->second];
}

std::vector<std::string_view> Variables::names() const
{
    std::vector<std::string_view> names;
    names.reserve(all_.size());
    for (const Variable& variable : all_)
        names.push_back(variable.name);
    return names;
}

void Variables::find_needs()
{
    needs_.resize(all_.size());
    for (std::size_t i = 0; i < all_.size(); ++i) {
        const std::string* const text = all_[i].definition->string();
        if (text == nullptr || text->size() > longest_expression)
            continue;
        for (const std::string_view name : names_in(*text))
            if (const auto number = numbers_.find(std::string{name}); number != numbers_.end())
                needs_[i].push_back(number->second);
        std::ranges::sort(needs_[i]);
        needs_[i].erase(std::unique(needs_[i].begin(), needs_[i].end()), needs_[i].end());
    }
}

bool Variables::is_circular(const Variable& variable)
{
    if (needs_.empty())
        find_needs();
    const auto first = static_cast<std::size_t>(&variable - all_.data());
    std::vector<bool> seen(all_.size());
    std::vector<std::size_t> open{first};
    while (!open.empty()) {
        const std::size_t number = open.back();
        open.pop_back();
        for (const std::size_t needed : needs_[number])
            if (!seen[needed]) {
                seen[needed] = true;
                open.push_back(needed);
            }
    }
    return seen[first];
}

}
