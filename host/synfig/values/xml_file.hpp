#pragma once

#include "host/text/source.hpp"

#include <cstddef>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::synfig {

/// The elements of a file, with an index of those that others refer to.
class XmlFile {
public:
    /// Throws Failure when the text is no XML, nests too deeply, or has too many tags.
    explicit XmlFile(const SourceText& source);

    pugi::xml_node root() const { return document_.document_element(); }
    /// "other.sif#:legs": such values and canvases are not available.
    static bool is_of_another_file(std::string_view id);
    /// Nothing if no element has that id. Only the last part of a path of ids counts: ":legs:left".
    pugi::xml_node value_with_id(std::string_view id) const;
    pugi::xml_node canvas_with_id(std::string_view id) const;
    /// The element with that guid that has content.
    pugi::xml_node with_guid(std::string_view guid) const;

    /// The guids of all elements <bone> that have content.
    std::vector<std::string> bones() const;

    /// The first child that is an element, or nothing.
    static pugi::xml_node first_element(pugi::xml_node parent);
    static std::size_t place(pugi::xml_node element);
    /// Throws Failure that names the file, the line and the column.
    [[noreturn]] void fail(std::size_t place, const std::string& text) const;

private:
    class Collecting;

    const SourceText& source_;
    pugi::xml_document document_;
    std::map<std::string, pugi::xml_node, std::less<>> values_;
    std::map<std::string, pugi::xml_node, std::less<>> canvases_;
    std::map<std::string, pugi::xml_node, std::less<>> guids_;
};

}
