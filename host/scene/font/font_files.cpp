#include "host/scene/font/font_files.hpp"

#include "host/kdl/parser.hpp"
#include "host/scene/font/font_shelf.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace kfast::scene {
namespace {

void add_names(const std::vector<kdl::Node>& nodes, std::set<std::string>& names)
{
    for (const kdl::Node& node : nodes) {
        for (const kdl::Property& property : node.properties)
            if (const std::string* const name = property.value.string(); name && property.name == "font")
                names.insert(*name);
        add_names(node.children, names);
    }
}

}

std::vector<std::filesystem::path> font_files(const SourceText& source)
{
    Diagnostics said_by_the_compiler;
    std::set<std::string> names;
    if (source.folder)
        add_names(kdl::parse(source.text, said_by_the_compiler).nodes, names);
    for (const std::string_view bundled : FontShelf::bundled_names())
        names.erase(std::string{bundled});
    std::vector<std::filesystem::path> files;
    files.reserve(names.size());
    for (const std::string& name : names)
        files.push_back(std::filesystem::path{*source.folder} / name);
    return files;
}

}
