#include "host/scene/path_reader.hpp"

#include "host/scene/property_rule.hpp"
#include "host/scene/svg_path.hpp"
#include "host/scene/value_reader.hpp"

namespace kfast::scene {
std::vector<Outline> read_path(const kdl::Node& node, std::size_t points_left, Reading& reading)
{
    const kdl::Value& value = node.arguments.front();
    const bool good = refuse_properties(node, reading);
    const auto data = read_text(value, reading);
    if (!good || !data)
        return {};
    Diagnostics findings;
    auto outlines = read_svg_path(*data, points_left, findings);
    const auto sorted = findings.sorted();
    for (const Diagnostic& finding : sorted)
        pass_on(finding, value, "path", reading);
    if (outlines.empty() && sorted.empty())
        reading.report.warning(value.place, "this path draws nothing");
    return outlines;
}

}
