#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace kfast::svg {

/// The elements of a text by their ids; of several with the same one, the first.
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
