#include "host/scene/values/spot_reader.hpp"

#include "host/geometry/path_scanner.hpp"
#include "host/scene/values/value_reader.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace kfast::scene {
namespace {

/// Numbers as in path data: a comma or spaces stand between them.
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
    const auto spot = spot_in(*text);
    if (!spot)
        context.report.error(value.place, "a place \"X,Y\" is expected here", "write \"20,200\"");
    else if (!in_range(*spot))
        report_out_of_range(value, coordinates, context.report);
    return spot && in_range(*spot) ? spot : std::nullopt;
}

}
