#pragma once

#include "host/text/source.hpp"

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace kfast::svg {

/// Parses the text of a drawing, with the entities that its own document type declares put in. Throws Failure
/// with line and column when it is no XML, or holds no drawing of SVG.
pugi::xml_document parsed(const SourceText& source);

/// The name of an element of SVG in a text that was parsed(), without a prefix. Empty for texts, and for
/// elements of other namespaces, such as those with Inkscape's own data.
std::string_view element_name(pugi::xml_node node);

/// The drawing: the outermost element.
pugi::xml_node drawing_of(const pugi::xml_document& document);

/// The id that an attribute "href" names in the same text, with or without the prefix "xlink"; else empty.
std::string_view referred_id(pugi::xml_node node);

/// The elements of a text by their ids; the first of several with the same one.
class ElementIndex {
public:
    explicit ElementIndex(pugi::xml_node root);

    /// Null if there is none.
    pugi::xml_node find(std::string_view id) const;

private:
    std::map<std::string, pugi::xml_node, std::less<>> elements_;
};

/// What "url(#id)" refers to, with or without quotes; else empty.
std::string_view url_id(std::string_view value);

}
