#include "host/synfig/values/xml_file.hpp"

#include "host/art/budget.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <functional>

namespace kfast::synfig {
namespace {

// A group inside a group is four levels of elements, and a value goes some ten deeper.
constexpr int deepest_element = 400;

std::string_view last_part(std::string_view id)
{
    const std::size_t separator = id.find_last_of(":#");
    return separator == std::string_view::npos ? id : id.substr(separator + 1);
}

pugi::xml_node found(const std::map<std::string, pugi::xml_node, std::less<>>& elements,
                     std::string_view name)
{
    const auto place = elements.find(name);
    return place == elements.end() ? pugi::xml_node{} : place->second;
}

}

class XmlFile::Collecting : public pugi::xml_tree_walker {
public:
    explicit Collecting(XmlFile& file) : file_{file} {}

    bool for_each(pugi::xml_node& element) override
    {
        if (depth() > deepest_element)
            file_.fail(place(element), "elements lie more than " + std::to_string(deepest_element) +
                                           " deep in each other: flatten some groups");
        if (element.type() != pugi::node_element)
            return true;
        if (const auto id = element.attribute("id"))
            (std::string_view{element.name()} == "canvas" ? file_.canvases_ : file_.values_)
                .emplace(id.value(), element);
        if (const auto guid = element.attribute("guid"); guid && element.first_child())
            file_.guids_.emplace(guid.value(), element);
        return true;
    }

private:
    XmlFile& file_;
};

XmlFile::XmlFile(const SourceText& source) : source_{source}
{
    art::Budget::check_parsed(source.name, static_cast<std::size_t>(std::ranges::count(source.text, '<')),
                              "tags");
    const auto parsed = document_.load_buffer(source.text.data(), source.text.size(), pugi::parse_default,
                                              pugi::encoding_utf8);
    if (!parsed)
        fail(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, parsed.offset)),
             std::string{"this is no XML: "} + parsed.description());
    Collecting collecting{*this};
    document_.traverse(collecting);
}

bool XmlFile::is_of_another_file(std::string_view id)
{
    return id.find('#') != std::string_view::npos && !id.starts_with('#');
}

pugi::xml_node XmlFile::value_with_id(std::string_view id) const
{
    return is_of_another_file(id) ? pugi::xml_node{} : found(values_, last_part(id));
}

pugi::xml_node XmlFile::canvas_with_id(std::string_view id) const
{
    return is_of_another_file(id) ? pugi::xml_node{} : found(canvases_, last_part(id));
}

pugi::xml_node XmlFile::with_guid(std::string_view guid) const { return found(guids_, guid); }

std::vector<std::string> XmlFile::bones() const
{
    std::vector<std::string> guids;
    for (const auto& [guid, element] : guids_)
        if (std::string_view{element.name()} == "bone")
            guids.push_back(guid);
    return guids;
}

pugi::xml_node XmlFile::first_element(pugi::xml_node parent)
{
    for (const pugi::xml_node child : parent.children())
        if (child.type() == pugi::node_element)
            return child;
    return {};
}

std::size_t XmlFile::place(pugi::xml_node element)
{
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, element.offset_debug()));
}

void XmlFile::fail(std::size_t place, const std::string& text) const
{
    const LineColumn at = line_column(source_.text, place);
    throw Failure(source_.name + ':' + std::to_string(at.line) + ':' + std::to_string(at.column) + ": " +
                  text);
}

}
