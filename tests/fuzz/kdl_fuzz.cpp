#include "host/kdl/canonical.hpp"
#include "host/kdl/parser.hpp"
#include "tests/demand.hpp"

#include <cstdint>
#include <string>
#include <string_view>

using namespace kfast;

namespace {

/// Every message can be shown, and its place lies inside the text.
void show(const Diagnostics& diagnostics, const SourceText& source)
{
    for (const Diagnostic& diagnostic : diagnostics.sorted()) {
        demand(diagnostic.place.offset <= source.text.size());
        demand(!format(diagnostic, source).empty());
    }
}

void check_text_offset(const kdl::Value& value, std::string_view text)
{
    if (value.text_offset)
        demand(text.substr(*value.text_offset).starts_with(*value.string()));
}

void check_places(const kdl::Node& node, std::string_view text)
{
    for (const kdl::Value& argument : node.arguments)
        check_text_offset(argument, text);
    for (const kdl::Property& property : node.properties)
        check_text_offset(property.value, text);
    for (const kdl::Node& child : node.children)
        check_places(child, text);
}

}

/// Any bytes at all: they are refused with messages that can be shown, or their canonical form reads as
/// itself.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const SourceText source{.name = "fuzz", .text = std::string(data, data + size)};
    Diagnostics diagnostics;
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    show(diagnostics, source);
    for (const kdl::Node& node : document.nodes)
        check_places(node, source.text);
    const std::string canonical = kdl::canonical(document);
    if (diagnostics.has_errors())
        return 0;

    Diagnostics again;
    const std::string reread = kdl::canonical(kdl::parse(canonical, again));
    demand(!again.has_errors());
    demand(reread == canonical);
    return 0;
}
