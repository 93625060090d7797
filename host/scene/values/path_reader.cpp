#include "host/scene/values/path_reader.hpp"

#include "host/geometry/svg_path.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/property_rule.hpp"

#include <utility>

namespace kfast::scene {

std::optional<std::vector<Outline>> read_path_data(const kdl::Value& value, std::size_t points_left,
                                                   SceneContext& context)
{
    const auto data = read_text(value, context.report);
    if (!data)
        return std::nullopt;
    Diagnostics findings;
    auto outlines = read_svg_path(*data, points_left, findings);
    const auto sorted = findings.sorted();
    for (const Diagnostic& finding : sorted)
        pass_on(finding, value, "path", context.report);
    if (outlines.empty() && sorted.empty())
        context.report.warning(value.place, "this path draws nothing");
    return findings.has_errors() ? std::nullopt : std::optional{std::move(outlines)};
}

std::vector<Outline> read_path(const kdl::Node& node, std::size_t points_left, SceneContext& context)
{
    const bool good = refuse_properties(node, context.report);
    auto outlines = read_path_data(node.arguments.front(), points_left, context);
    if (!good || !outlines)
        return {};
    return std::move(*outlines);
}

}
