#include "host/svg/markup/svg_text.hpp"

#include "host/art/budget.hpp"
#include "host/program/failure.hpp"
#include "host/svg/markup/length.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <pugixml.hpp>
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

    /// The declarations of elements at this depth or deeper end here.
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

/// Gives elements of SVG their names without a prefix, and all others a name with one. An outermost element
/// without a prefix is one of SVG, too.
void resolve_namespaces(pugi::xml_document& document)
{
    Resolver resolver{document.document_element()};
    document.traverse(resolver);
}

constexpr std::size_t longest_text = std::size_t{1} << 26; ///< bytes, with entities put in
constexpr std::size_t max_entity_name = 256;               ///< of an entity

using Entities = std::map<std::string, std::string, std::less<>>;

/// The declarations inside of the document type that have a value in quotes.
Entities declared_entities(std::string_view text)
{
    constexpr std::string_view opening = "<!ENTITY";
    constexpr std::string_view space = " \t\r\n";
    Entities entities;
    for (std::size_t at = text.find(opening); at != text.npos; at = text.find(opening, at)) {
        const std::size_t name = text.find_first_not_of(space, at + opening.size());
        const std::size_t name_end = text.find_first_of(space, name);
        const std::size_t quote = text.find_first_not_of(space, name_end);
        at += opening.size();
        if (quote == text.npos || (text[quote] != '"' && text[quote] != '\''))
            continue;
        const std::size_t end = text.find(text[quote], quote + 1);
        if (end != text.npos)
            entities.emplace(text.substr(name, name_end - name), text.substr(quote + 1, end - quote - 1));
    }
    return entities;
}

/// Illustrator writes names of namespaces, and its older versions whole styles, as entities. Their values are
/// inserted as they are, so that entities of entities cannot grow without bounds.
std::string with_entities(const SourceText& source)
{
    const std::string_view text = source.text;
    const Entities entities = declared_entities(text.substr(0, text.find("<svg")));
    if (entities.empty())
        return source.text;
    std::string result;
    std::size_t copied = 0;
    for (std::size_t at = text.find('&'); at != text.npos; at = text.find('&', at + 1)) {
        const std::string_view name = text.substr(at + 1, max_entity_name);
        const std::size_t length = name.find(';');
        const auto entity = entities.find(name.substr(0, length == name.npos ? 0 : length));
        if (entity == entities.end())
            continue;
        result.append(text.substr(copied, at - copied)).append(entity->second);
        copied = at + 1 + length + 1;
        if (result.size() > longest_text)
            throw Failure(source.name + ": its entities make it longer than 64 MB: write them out");
    }
    return result.append(text.substr(copied));
}

Failure at_place(const SourceText& source, std::string_view text, std::size_t offset,
                 const std::string& message)
{
    const LineColumn place = line_column(text, offset);
    return Failure(source.name + ':' + std::to_string(place.line) + ':' + std::to_string(place.column) +
                   ": error: " + message);
}

/// pugixml's descriptions are sentences.
std::string beginning_small(std::string text)
{
    if (!text.empty() && text.front() >= 'A' && text.front() <= 'Z')
        text.front() = static_cast<char>(text.front() - 'A' + 'a');
    return text;
}

}

pugi::xml_document parsed(const SourceText& source)
{
    const std::string text = with_entities(source);
    art::Budget::check_parsed(source.name, static_cast<std::size_t>(std::ranges::count(text, '<')), "tags");
    pugi::xml_document document;
    const auto result = document.load_buffer(text.data(), text.size());
    if (!result)
        throw at_place(source, text, static_cast<std::size_t>(result.offset),
                       "this is no XML: " + beginning_small(result.description()));
    resolve_namespaces(document);
    if (!drawing_of(document))
        throw Failure(source.name + ": there is no drawing in it: its outermost element is not <svg>");
    return document;
}

std::string_view element_name(pugi::xml_node node)
{
    if (node.type() != pugi::node_element)
        return {};
    const std::string_view name = node.name();
    return name.find(':') == name.npos ? name : std::string_view{};
}

pugi::xml_node drawing_of(const pugi::xml_document& document)
{
    const pugi::xml_node root = document.document_element();
    return element_name(root) == "svg" ? root : pugi::xml_node{};
}

std::string_view referred_id(pugi::xml_node node)
{
    const auto plain = node.attribute("href");
    const std::string_view reference = plain ? plain.value() : node.attribute("xlink:href").value();
    return reference.starts_with('#') ? reference.substr(1) : std::string_view{};
}

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
