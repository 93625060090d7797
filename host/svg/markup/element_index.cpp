#include "host/svg/markup/element_index.hpp"

#include "host/svg/markup/length.hpp"

namespace kfast::svg {
namespace {

struct Filler : pugi::xml_tree_walker {
    explicit Filler(std::map<std::string, pugi::xml_node, std::less<>>& filled) : elements{filled} {}

    bool for_each(pugi::xml_node& node) override
    {
        if (const auto id = node.attribute("id"))
            elements.emplace(id.value(), node);
        return true;
    }

    std::map<std::string, pugi::xml_node, std::less<>>& elements;
};

}

ElementIndex::ElementIndex(pugi::xml_node root)
{
    Filler filler{elements_};
    root.traverse(filler);
}

pugi::xml_node ElementIndex::find(std::string_view id) const
{
    const auto found = elements_.find(id);
    return found == elements_.end() ? pugi::xml_node{} : found->second;
}

std::string_view url_id(std::string_view value)
{
    value = trimmed(value);
    if (!value.starts_with("url("))
        return {};
    value = trimmed(value.substr(4, value.find(')') - 4));
    if (!value.empty() && (value.front() == '"' || value.front() == '\''))
        value = value.substr(1, value.find(value.front(), 1) - 1);
    return value.starts_with('#') ? value.substr(1) : std::string_view{};
}

}
