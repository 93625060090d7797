#include "host/svg/markup/svg_text.hpp"

#include "host/program/failure.hpp"
#include "host/svg/markup/namespaces.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace kfast::svg {
namespace {

constexpr std::size_t longest_text = std::size_t{1} << 26; ///< bytes, with entities put in
constexpr std::size_t longest_name = 256;                  ///< of an entity

using Entities = std::map<std::string, std::string, std::less<>>;

/// Those with a value in quotes of the declarations inside of the document type.
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
/// put in as they are, so that entities of entities cannot grow without bounds.
std::string with_entities(const SourceText& source)
{
    const std::string_view text = source.text;
    const Entities entities = declared_entities(text.substr(0, text.find("<svg")));
    if (entities.empty())
        return source.text;
    std::string result;
    std::size_t copied = 0;
    for (std::size_t at = text.find('&'); at != text.npos; at = text.find('&', at + 1)) {
        const std::string_view name = text.substr(at + 1, longest_name);
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

}
