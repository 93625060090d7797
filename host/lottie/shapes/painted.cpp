#include "host/lottie/drawings/carried.hpp"
#include "host/lottie/drawings/symbol_table.hpp"
#include "host/lottie/shapes/shapes.hpp"
#include "host/lottie/shapes/transform.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace kfast::lottie {
namespace {

using art::Node;

/// A path, and the groups that transform it within the list of a style, the innermost first.
struct TransformedPath {
    const PathItem* path = nullptr;
    std::vector<const GroupItem*> groups;
};

void collect(const ShapeItem& item, std::vector<TransformedPath>& paths)
{
    if (const auto* path = std::get_if<PathItem>(&item.content))
        paths.push_back({path, {}});
    const auto* group = std::get_if<GroupItem>(&item.content);
    if (!group)
        return;
    const std::size_t before = paths.size();
    for (const ShapeItem& inner : group->items)
        collect(inner, paths);
    for (std::size_t i = before; i < paths.size(); ++i)
        paths[i].groups.push_back(group);
}

bool keeps_widths(const art::Transform& transform)
{
    const auto is_one = [](const art::Channel& scale) { return scale.is_still() && scale.value() == 1; };
    return is_one(transform.scale_x) && is_one(transform.scale_y) && transform.skew.is_still() &&
           transform.skew.value() == 0;
}

/// Whether a shape may be put into the groups of its paths instead of taking their motion into its points.
bool can_lie_in_groups(const std::vector<TransformedPath>& paths, bool has_line)
{
    const auto& groups = paths.front().groups;
    return !std::ranges::all_of(groups, [](const GroupItem* group) { return is_still(group->transform); }) &&
           std::ranges::all_of(paths, [&](const TransformedPath& path) { return path.groups == groups; }) &&
           (!has_line || std::ranges::all_of(
                             groups, [](const GroupItem* group) { return keeps_widths(group->transform); }));
}

/// Whether lengths keep their proportions.
bool is_similarity(const GroupItem& group)
{
    const art::Transform& transform = group.transform;
    return transform.scale_x == transform.scale_y && transform.skew == art::Channel{0} &&
           group.shown == std::vector<art::Span>{{}};
}

/// A scene has no offset beyond that.
bool is_within_offsets(const art::Trim& trim)
{
    constexpr double max = 16;
    return std::ranges::all_of(trim.offset.keys, [](const auto& key) { return std::abs(key.value) <= max; });
}

/// The trim of all paths, if they are those that one modifier trims: then the shape is trimmed as a whole.
/// Null if each path has to be trimmed before they are put together.
const art::Trim* common_trim(const StyleItem& style, const std::vector<TransformedPath>& paths,
                             bool in_groups)
{
    const auto& first = paths.front().path->untrimmed;
    if (!first || !style.stroke || !is_within_offsets(*first->trim))
        return nullptr;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const auto& own = paths[i].path->untrimmed;
        if (!own || own->trim != first->trim || (first->trim->together && own->index != i))
            return nullptr;
        const auto keeps_lengths = [](const GroupItem* group) { return is_similarity(*group); };
        if (!in_groups && !std::ranges::all_of(paths[i].groups, keeps_lengths))
            return nullptr;
    }
    return first->trim->together && first->count != paths.size() ? nullptr : first->trim.get();
}

/// Otherwise it is an even line. Of an odd number of lengths, all are gaps in turn.
bool has_gaps(const Dashes& dashes)
{
    const std::size_t count = dashes.lengths.size();
    for (std::size_t i = 0; i < count; ++i)
        if ((i % 2 == 1 || count % 2 == 1) && dashes.lengths[i] != art::Channel{0})
            return true;
    return false;
}

bool is_empty(const art::Animated<art::Drawing>& drawing)
{
    return std::ranges::all_of(drawing.keys, [](const auto& key) { return key.value.outlines.empty(); });
}

bool does_nothing(const Node& node)
{
    return node.transform == art::Transform{} && node.opacity == art::Channel{1} &&
           node.shown == std::vector<art::Span>{{}};
}

/// A group of one shape is that shape.
Node flattened(Node group)
{
    auto& nodes = std::get<art::Group>(group.content).nodes;
    if (nodes.size() != 1 || !does_nothing(nodes.front()))
        return group;
    Node inner = std::move(nodes.front());
    if (group.name.empty())
        group.name = std::move(inner.name);
    group.content = std::move(inner.content);
    return group;
}

/// Names of paths are more meaningful than those of styles.
const std::string& name_of(const StyleItem& style, const std::vector<TransformedPath>& paths)
{
    const std::string& path = paths.front().path->name;
    return path.empty() || (paths.size() > 1 && !style.name.empty()) ? style.name : path;
}

Node within(const GroupItem& group, std::vector<Node> nodes)
{
    Node node;
    node.name = group.name;
    node.transform = group.transform;
    node.shown = group.shown;
    node.content = art::Group{std::move(nodes)};
    return flattened(std::move(node));
}

/// For a line, the fill below it that is painted with the same paths.
const StyleItem* fill_below(const StyleItem& style, const ShapeItem& next)
{
    const auto* below = std::get_if<StyleItem>(&next.content);
    return style.stroke && style.dashes.lengths.empty() && below && below->fill ? below : nullptr;
}

class Painter {
public:
    explicit Painter(const Reading& reading) : reading_{reading} {}

    std::vector<Node> paint(const std::vector<ShapeItem>& items) const
    {
        std::vector<Node> nodes;
        std::vector<TransformedPath> paths;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const auto* style = std::get_if<StyleItem>(&items[i].content);
            if (!style) {
                add_group(items[i], nodes);
                collect(items[i], paths);
                continue;
            }
            const StyleItem* const below = i + 1 < items.size() ? fill_below(*style, items[i + 1]) : nullptr;
            add_shape(*style, below, paths, nodes);
            i += below ? 1 : 0;
        }
        std::ranges::reverse(nodes);
        return nodes;
    }

private:
    void add_group(const ShapeItem& item, std::vector<Node>& nodes) const
    {
        const auto* group = std::get_if<GroupItem>(&item.content);
        if (!group)
            return;
        Reading reading{reading_};
        if (!group->name.empty())
            reading.layer += " / " + group->name;
        if (changes_while_skewed(group->transform))
            reading.symbols = nullptr;
        if (group->copies && reading.symbols && !reading.symbols->is_full()) {
            if (group->is_first_copy)
                add_copies(*group, reading, nodes);
            return;
        }
        std::vector<Node> inner = Painter{reading}.paint(group->items);
        if (inner.empty())
            return;
        Node node = within(*group, std::move(inner));
        node.opacity = group->opacity;
        nodes.push_back(std::move(node));
    }

    /// All copies of which the group is one.
    static void add_copies(const GroupItem& group, const Reading& reading, std::vector<Node>& nodes)
    {
        std::vector<Node> inner = Painter{reading}.paint(group.items);
        if (inner.empty())
            return;
        art::Symbol symbol{
            .name = inner.front().name, .frames = reading.time.seen.to, .loop = {}, .nodes = {}};
        Node content;
        content.transform = group.copies->content;
        content.content = art::Group{std::move(inner)};
        symbol.nodes.push_back(std::move(content));
        SymbolTable& symbols = *reading.symbols;
        const Box box = box_in(symbol.nodes, {0, symbol.frames}, symbols.boxes, reading.budget);
        Node use;
        use.name = symbol.name;
        use.transform = group.copies->place;
        use.content = art::Use{.symbol = symbols.add(std::move(symbol), box), .copies = group.copies->copies};
        nodes.push_back(std::move(use));
    }

    void add_shape(const StyleItem& style, const StyleItem* below, const std::vector<TransformedPath>& paths,
                   std::vector<Node>& nodes) const
    {
        if (paths.empty())
            return;
        reading_.budget.take_node();
        art::Shape shape;
        shape.fill = below ? below->fill : style.fill;
        shape.stroke = style.stroke;
        const bool in_groups = can_lie_in_groups(paths, shape.stroke.has_value());
        const art::Trim* trim = common_trim(style, paths, in_groups);
        MovingDrawing drawing = drawing_of(style, paths, in_groups, trim != nullptr);
        if (are_of_scenes(style.dashes, drawing)) {
            if (has_gaps(style.dashes))
                shape.stroke->dashes = style.dashes;
        } else {
            if (std::exchange(trim, nullptr) != nullptr)
                drawing = drawing_of(style, paths, in_groups, false);
            drawing = dashed_or_reported(std::move(drawing), style.dashes);
        }
        if (trim != nullptr)
            shape.trim = *trim;
        shape.drawing = keys_of(drawing, reading_.budget);
        if (is_empty(shape.drawing))
            return;
        Node node;
        node.name = name_of(style, paths);
        node.content = std::move(shape);
        if (in_groups)
            for (const GroupItem* group : paths.front().groups)
                node = within(*group, {std::move(node)});
        nodes.push_back(std::move(node));
    }

    MovingDrawing drawing_of(const StyleItem& style, const std::vector<TransformedPath>& paths,
                             bool in_groups, bool is_untrimmed) const
    {
        const bool is_cut = !style.dashes.lengths.empty();
        std::vector<MovingDrawing> drawings;
        for (const TransformedPath& path : paths) {
            const PathItem& item = *path.path;
            MovingDrawing drawing = is_untrimmed            ? item.untrimmed->drawing
                                    : item.plain && !is_cut ? *item.plain
                                                            : item.drawing;
            if (!in_groups)
                for (const GroupItem* group : path.groups)
                    drawing = while_shown(carried(std::move(drawing), group->transform), group->shown);
            reading_.budget.take_computed_points(drawing.moments.list().size() + 1);
            drawings.push_back(std::move(drawing));
        }
        return together(std::move(drawings));
    }

    MovingDrawing dashed_or_reported(MovingDrawing stroke, const Dashes& dashes) const
    {
        DashedDrawing result = dashed(std::move(stroke), dashes);
        if (result.dashing == Dashing::stand_still)
            reading_.losses.add({"more than " + std::to_string(max_moving_dashes) + " moving dashes",
                                 reading_.layer, std::nullopt, "dashes that stand still"});
        if (result.dashing == Dashing::none)
            reading_.losses.add({"too many dashes", reading_.layer, std::nullopt, "a whole line"});
        return std::move(result.drawing);
    }

    const Reading& reading_;
};

}

std::vector<PathItem*> paths_of(std::vector<ShapeItem>& items)
{
    std::vector<PathItem*> paths;
    for (ShapeItem& item : items)
        if (auto* path = std::get_if<PathItem>(&item.content)) {
            paths.push_back(path);
        } else if (auto* group = std::get_if<GroupItem>(&item.content)) {
            const auto inner = paths_of(group->items);
            paths.insert(paths.end(), inner.begin(), inner.end());
        }
    return paths;
}

std::vector<art::Node> painted(const std::vector<ShapeItem>& items, const Reading& reading)
{
    return Painter{reading}.paint(items);
}

}
