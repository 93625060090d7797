#include "host/svg/markup/namespaces.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::svg {
namespace {

constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";

/// The prefix that an attribute declares; "" for that of elements without one.
std::optional<std::string_view> declared_prefix(std::string_view attribute)
{
    constexpr std::string_view declaration = "xmlns";
    if (attribute == declaration)
        return "";
    if (attribute.starts_with("xmlns:"))
        return attribute.substr(declaration.size() + 1);
    return std::nullopt;
}

class Resolver : public pugi::xml_tree_walker {
public:
    explicit Resolver(pugi::xml_node root) : unprefixed_{root.attribute("xmlns").value()} {}

    bool for_each(pugi::xml_node& node) override
    {
        if (node.type() != pugi::node_element)
            return true;
        leave(depth());
        for (const auto attribute : node.attributes())
            if (const auto prefix = declared_prefix(attribute.name()))
                declare(std::string{*prefix}, attribute.value());
        rename(node);
        return true;
    }

private:
    void declare(std::string prefix, std::string_view name)
    {
        declared_[prefix].push_back(name);
        order_.emplace_back(depth(), std::move(prefix));
    }

    /// What elements declare that lie as deep or deeper holds no more.
    void leave(int depth)
    {
        for (; !order_.empty() && order_.back().first >= depth; order_.pop_back())
            declared_[order_.back().second].pop_back();
    }

    std::string_view namespace_of(std::string_view prefix) const
    {
        const auto found = declared_.find(prefix);
        return found == declared_.end() || found->second.empty() ? std::string_view{} : found->second.back();
    }

    void rename(pugi::xml_node node) const
    {
        const std::string name = node.name();
        const std::size_t colon = name.find(':');
        if (colon == name.npos) {
            const std::string_view own = namespace_of("");
            if (own != unprefixed_ && own != svg_namespace)
                node.set_name(("other:" + name).c_str());
        } else if (namespace_of(std::string_view{name}.substr(0, colon)) == svg_namespace) {
            node.set_name(name.substr(colon + 1).c_str());
        }
    }

    std::string_view unprefixed_;
    std::map<std::string, std::vector<std::string_view>, std::less<>> declared_;
    std::vector<std::pair<int, std::string>> order_; ///< with the depth of the element
};

}

void resolve_namespaces(pugi::xml_document& document)
{
    Resolver resolver{document.document_element()};
    document.traverse(resolver);
}

}
