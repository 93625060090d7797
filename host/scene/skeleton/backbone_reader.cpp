#include "host/scene/skeleton/backbone_reader.hpp"

#include "host/geometry/band.hpp"
#include "host/geometry/drawing.hpp"
#include "host/scene/values/geometry_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace kfast::scene {
namespace {

constexpr NodeForm backbone_form{"backbone", "backbone X Y X Y …", 4, NodeForm::any_number};

/// What gives a backbone its outline.
struct Side {
    NodeForm form;
    const kdl::Node* BackboneNodes::*node;
};

constexpr std::array sides{
    Side{{"width", "width PIXELS, or one for each node", 1, NodeForm::any_number}, &BackboneNodes::width},
    Side{{"left", "left X Y X Y …", 4, NodeForm::any_number}, &BackboneNodes::left},
    Side{{"right", "right X Y X Y …", 4, NodeForm::any_number}, &BackboneNodes::right},
};

const Side* find_side(std::string_view name)
{
    const auto side =
        std::ranges::find(sides, name, [](const Side& candidate) { return candidate.form.name; });
    return side == sides.end() ? nullptr : &*side;
}

std::vector<Point> rounded(const std::vector<Vec2>& spots)
{
    std::vector<Point> points;
    points.reserve(spots.size());
    for (const Vec2 spot : spots)
        points.push_back({to_sixteenths(spot.x), to_sixteenths(spot.y)});
    return points;
}

/// The cross product of the vectors from `a` to the others.
std::int64_t cross(Point a, Point b, Point c)
{
    const auto product = [](std::int64_t x, std::int64_t y) { return x * y; };
    return product(b.x - a.x, c.y - a.y) - product(b.y - a.y, c.x - a.x);
}

/// Whether a side does not leave the backbone between node `i` and the next.
bool has_no_width(const Backbone& backbone, const std::vector<Point>& side, std::size_t i)
{
    const Point from = backbone.nodes[i];
    const Point to = backbone.nodes[i + 1];
    return cross(from, to, side[i]) == 0 && cross(from, to, side[i + 1]) == 0;
}

class BackboneReader {
public:
    BackboneReader(const BackboneNodes& nodes, const ReadBackbone* before, SceneContext& context)
        : nodes_{nodes}, before_{before}, context_{context}
    {
    }

    std::optional<ReadBackbone> read()
    {
        if (!read_nodes() || !read_outline() || !has_width())
            return std::nullopt;
        return std::move(read_);
    }

private:
    bool read_nodes()
    {
        const auto spots = read_points(*nodes_.backbone, backbone_form);
        if (!spots)
            return false;
        spots_ = *spots;
        read_.backbone.nodes = rounded(spots_);
        return has_known_form() && is_line();
    }

    std::optional<std::vector<Vec2>> read_points(const kdl::Node& node, const NodeForm& form)
    {
        if (!fits(node, form, context_.report) || !refuse_properties(node, context_.report))
            return std::nullopt;
        return read_spots(node, context_);
    }

    bool has_known_form()
    {
        const std::size_t count = spots_.size();
        if (before_ == nullptr || count == before_->backbone.nodes.size())
            return true;
        return context_.report.error(nodes_.backbone->name_span,
                                     "this backbone has " + counted(count, "node") +
                                         ", in the skeleton before it " +
                                         std::to_string(before_->backbone.nodes.size()),
                                     "all skeletons of an object have the same number of nodes");
    }

    bool is_line()
    {
        const auto& nodes = read_.backbone.nodes;
        const auto second = std::ranges::adjacent_find(nodes);
        if (second == nodes.end())
            return true;
        const auto x = static_cast<std::size_t>(second - nodes.begin() + 1) * 2;
        const auto& values = nodes_.backbone->arguments;
        return context_.report.error(span(values[x].place, values[x + 1].place),
                                     "this node lies where the one before it does",
                                     "move it, by 1/16 px at least, or remove it");
    }

    bool read_outline()
    {
        const kdl::Node* const given = nodes_.left != nullptr ? nodes_.left : nodes_.right;
        if (given == nullptr)
            return find_widths() && make_band();
        if (nodes_.width != nullptr)
            return context_.report.error(nodes_.width->name_span,
                                         "a backbone has either a width or a left and a right side",
                                         "remove one of them");
        if (nodes_.left == nullptr || nodes_.right == nullptr)
            return context_.report.error(given->name_span, "this side has no other one",
                                         "a backbone has both left and right, or a width");
        return read_side(*nodes_.left, read_.backbone.left) && read_side(*nodes_.right, read_.backbone.right);
    }

    bool read_side(const kdl::Node& node, std::vector<Point>& side)
    {
        const auto spots = read_points(node, find_side(node.name)->form);
        if (!spots)
            return false;
        side = rounded(*spots);
        return side.size() == spots_.size() ||
               context_.report.error(node.name_span,
                                     "this side has " + counted(side.size(), "point") +
                                         ", its backbone has " + counted(spots_.size(), "node"),
                                     "give it one point for each node");
    }

    bool find_widths()
    {
        if (nodes_.width != nullptr)
            return read_widths(*nodes_.width);
        if (before_ != nullptr)
            read_.widths = before_->widths;
        return !read_.widths.empty() ||
               context_.report.error(nodes_.backbone->name_span, "this backbone has no width",
                                     "write width PIXELS behind it, or left and right");
    }

    bool read_widths(const kdl::Node& node)
    {
        if (!fits(node, find_side(node.name)->form, context_.report) ||
            !refuse_properties(node, context_.report))
            return false;
        const auto widths = read_numbers(node.arguments, std::array{extents}, context_.report);
        if (!widths)
            return false;
        read_.widths = *widths;
        if (widths->size() == 1)
            read_.widths.resize(spots_.size(), widths->front());
        return read_.widths.size() == spots_.size() ||
               context_.report.error(node.name_span,
                                     "there are " + counted(widths->size(), "width") +
                                         " here, the backbone has " + counted(spots_.size(), "node"),
                                     "give one width for all nodes, or one for each");
    }

    bool make_band()
    {
        const BandSides band = sides_of_band(spots_, read_.widths);
        const auto is_inside = [](Vec2 spot) { return in_range(spot); };
        if (!std::ranges::all_of(band.left, is_inside) || !std::ranges::all_of(band.right, is_inside))
            return context_.report.error(
                nodes_.backbone->name_span,
                "the outline of this backbone reaches more than 2047 px from the origin");
        read_.backbone.left = rounded(band.left);
        read_.backbone.right = rounded(band.right);
        return true;
    }

    bool has_width()
    {
        return has_width(read_.backbone.left, nodes_.left) && has_width(read_.backbone.right, nodes_.right);
    }

    bool has_width(const std::vector<Point>& side, const kdl::Node* node)
    {
        for (std::size_t i = 0; i + 1 < side.size(); ++i)
            if (has_no_width(read_.backbone, side, i))
                return context_.report.error((node != nullptr           ? node
                                              : nodes_.width != nullptr ? nodes_.width
                                                                        : nodes_.backbone)
                                                 ->name_span,
                                             "the backbone has no width between its nodes " +
                                                 std::to_string(i + 1) + " and " + std::to_string(i + 2),
                                             "make it wider at one of them at least");
        return true;
    }

    const BackboneNodes& nodes_;
    const ReadBackbone* before_;
    SceneContext& context_;
    std::vector<Vec2> spots_;
    ReadBackbone read_;
};

}

bool is_side(std::string_view name) { return find_side(name) != nullptr; }

bool add_side(const kdl::Node& node, BackboneNodes& nodes, SceneContext& context)
{
    const kdl::Node*& place = nodes.*find_side(node.name)->node;
    if (place != nullptr)
        return context.report.error(node.name_span,
                                    "this backbone has its " + node.name + " already, on " +
                                        context.report.line(place->name_span),
                                    "remove one of them");
    place = &node;
    return true;
}

std::optional<ReadBackbone> read_backbone(const BackboneNodes& nodes, const ReadBackbone* before,
                                          SceneContext& context)
{
    return BackboneReader{nodes, before, context}.read();
}

std::vector<NodeSchema> backbone_schema()
{
    std::vector<NodeSchema> words{{backbone_form.name, backbone_form, {ValueKind::pixels(coordinates)}}};
    for (const Side& side : sides) {
        const bool is_width = side.node == &BackboneNodes::width;
        words.push_back({side.form.name, side.form, {ValueKind::pixels(is_width ? extents : coordinates)}});
    }
    return words;
}

}
