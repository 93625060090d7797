#include "host/scene/values/geometry_reader.hpp"

#include "host/geometry/outline.hpp"
#include "host/geometry/path_scanner.hpp"
#include "host/geometry/svg_path.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/expression.hpp"
#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace kfast::scene {

namespace {

/// Numbers as in path data: separated by a comma or spaces.
std::optional<Vec2> spot_in(std::string_view text)
{
    PathScanner scanner{text};
    scanner.skip_space();
    const auto x = scanner.number();
    scanner.skip_separator();
    const auto y = scanner.number();
    scanner.skip_space();
    if (!x || !y || !scanner.at_end())
        return std::nullopt;
    return Vec2{*x, *y};
}

/// Two expressions with a comma between them. Of other texts it says that they are none.
std::optional<Vec2> computed_spot(const kdl::Value& value, std::string_view text, SceneContext& context)
{
    const auto x = schema::evaluate_front(text, 0, context.variables);
    const std::size_t comma = std::min(text.find_first_not_of(' ', x.end), text.size());
    const bool has_comma = text.substr(comma).starts_with(',');
    const auto y =
        has_comma ? schema::evaluate_front(text, comma + 1, context.variables) : schema::Evaluation{};
    const bool is_whole = has_comma && text.find_first_not_of(' ', y.end) == text.npos;
    const auto& wrong = x.finding ? x : y;
    if (wrong.finding && text.find(',') != text.npos && !context.variables.empty())
        result_of(wrong, value, context.report);
    else if (!wrong.finding && is_whole)
        return x.value && y.value ? std::optional{Vec2{*x.value, *y.value}} : std::nullopt;
    else
        context.report.error(value.place, "a place \"X,Y\" is expected here", "write \"20,200\"");
    return std::nullopt;
}

}

std::optional<std::vector<Vec2>> read_spots(const kdl::Node& node, SceneContext& context)
{
    const auto numbers = read_numbers(node.arguments, std::array{coordinates}, context.report);
    if (!numbers)
        return std::nullopt;
    if (numbers->size() % 2 != 0) {
        context.report.error(node.arguments.back().place, "this x has no y", "add the y, or remove this x");
        return std::nullopt;
    }
    std::vector<Vec2> spots;
    for (std::size_t i = 0; i < numbers->size(); i += 2)
        spots.push_back({(*numbers)[i], (*numbers)[i + 1]});
    return spots;
}

std::optional<Vec2> read_spot(const kdl::Node& node, SceneContext& context)
{
    const auto spots = read_spots(node, context);
    return spots ? std::optional{spots->front()} : std::nullopt;
}

std::optional<Vec2> read_spot(const kdl::Value& value, SceneContext& context)
{
    const auto text = read_text(value, context.report);
    if (!text)
        return std::nullopt;
    auto spot = spot_in(*text);
    if (!spot)
        spot = computed_spot(value, *text, context);
    if (spot && !in_range(*spot))
        report_out_of_range(value, coordinates, context.report);
    return spot && in_range(*spot) ? spot : std::nullopt;
}

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

std::optional<Outline> read_followed_path(const kdl::Value& data, std::string_view what,
                                          SceneContext& context)
{
    const auto outlines = read_path_data(data, max_points, context);
    if (!outlines)
        return std::nullopt;
    if (outlines->size() > 1) {
        context.report.error(data.place,
                             std::string{what} + " follows one stroke; this path has " +
                                 std::to_string(outlines->size()),
                             "leave out all M but the first, and what is behind Z");
        return std::nullopt;
    }
    if (!outlines->empty() && !quantized(outlines->front()).segments.empty())
        return outlines->front();
    context.report.error(data.place, "this path leads nowhere", "write one such as \"M 20 20 L 80 20\"");
    return std::nullopt;
}

std::optional<Path> read_along_path(const kdl::Value& data, SceneContext& context)
{
    const auto outline = read_followed_path(data, "an item", context);
    return outline ? std::optional{Path{.stroke = quantized(*outline)}} : std::nullopt;
}

}
