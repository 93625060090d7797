#include "host/scene/path_reader.hpp"

#include "host/scene/property_rule.hpp"
#include "host/scene/svg_path.hpp"
#include "host/scene/value_reader.hpp"

#include <utility>

namespace kfast::scene {

std::optional<std::vector<Outline>> read_path_data(const kdl::Value& value, std::size_t points_left,
                                                   Reading& reading)
{
    const auto data = read_text(value, reading);
    if (!data)
        return std::nullopt;
    Diagnostics findings;
    auto outlines = read_svg_path(*data, points_left, findings);
    const auto sorted = findings.sorted();
    for (const Diagnostic& finding : sorted)
        pass_on(finding, value, "path", reading);
    if (outlines.empty() && sorted.empty())
        reading.report.warning(value.place, "this path draws nothing");
    return findings.has_errors() ? std::nullopt : std::optional{std::move(outlines)};
}

std::vector<Outline> read_path(const kdl::Node& node, std::size_t points_left, Reading& reading)
{
    const bool good = refuse_properties(node, reading);
    auto outlines = read_path_data(node.arguments.front(), points_left, reading);
    if (!good || !outlines)
        return {};
    return std::move(*outlines);
}

}
