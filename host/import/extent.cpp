#include "host/import/extent.hpp"

#include "host/art/prepare/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <variant>

namespace kfast::importing {

namespace {

std::size_t point_count(const art::Drawing& drawing)
{
    std::size_t count = 0;
    for (const scene::Outline& outline : drawing.outlines)
        count += 1 + outline.curves.size();
    return count;
}

class Count {
public:
    void add(const std::vector<art::Node>& nodes)
    {
        for (const art::Node& node : nodes) {
            add_keys_of(node.transform);
            add_keys(node.opacity);
            if (const auto* const group = std::get_if<art::Group>(&node.content))
                add_group(*group);
            else if (std::holds_alternative<art::Use>(node.content))
                ++extent_.groups;
            else
                add(std::get<art::Shape>(node.content));
        }
    }

    void add(const art::Rig& rig)
    {
        for (const art::Bone& bone : rig.bones) {
            add_keys(bone.rotation, bone.x, bone.y);
            if (bone.length)
                add_keys(*bone.length);
        }
    }

    const Extent& extent() const { return extent_; }

private:
    template <typename... Values>
    void add_keys(const art::Animated<Values>&... animated)
    {
        extent_.keys += (0 + ... + (animated.is_still() ? 0 : animated.keys.size()));
    }

    void add_keys_of(const art::Transform& transform)
    {
        add_keys(transform.anchor_x, transform.anchor_y, transform.x, transform.y, transform.z,
                 transform.scale_x, transform.scale_y, transform.rotate, transform.rotate_x,
                 transform.rotate_y, transform.skew, transform.skew_axis);
        if (transform.path)
            add_keys(transform.path->share);
    }

    void add_group(const art::Group& group)
    {
        ++extent_.groups;
        add(group.nodes);
    }

    void add(const art::Shape& shape)
    {
        ++extent_.figures;
        add_keys(shape.drawing);
        for (const auto& key : shape.drawing.keys)
            extent_.points += point_count(key.value);
        if (shape.fill)
            add_keys(shape.fill->colour, shape.fill->opacity);
        if (shape.stroke)
            add_keys(shape.stroke->colour, shape.stroke->opacity, shape.stroke->width);
    }

    Extent extent_;
};

}

Extent extent_of(const art::Document& document)
{
    Count count;
    count.add(document.nodes);
    for (const art::Symbol& symbol : document.symbols)
        count.add(symbol.nodes);
    for (const art::Rig& rig : document.rigs)
        count.add(rig);
    return count.extent();
}

namespace {

std::string size_text(double width, double height)
{
    std::ostringstream text;
    text << width << 'x' << height;
    return text.str();
}

double whole_side(double side) { return std::clamp(std::round(side), 1.0, double{longest_side}); }

}

void fit_canvas(art::Document& document, std::optional<Size> wanted, double share, art::Losses& losses)
{
    const std::string before = size_text(document.width, document.height);
    const Size room = wanted.value_or(Size{longest_side, longest_side});
    const double fitting = std::min(room.width / document.width, room.height / document.height);
    const double factor = share * (wanted ? fitting : std::min(fitting, 1.0));
    if (factor != 1)
        art::scale(document, factor);
    document.width = whole_side(document.width);
    document.height = whole_side(document.height);
    if (factor != 1 && !wanted)
        losses.add({"canvas of " + before + " pixels", "", std::nullopt,
                    "all of it smaller, on " + size_text(document.width, document.height)});
}

double share_within_reach(const art::Document& fitted, const scene_text::Reach& reach, bool is_smaller)
{
    // Simplification treats art of another size only nearly the same.
    constexpr double room = 0.999 * scene_text::widest_reach;
    const double share = room / std::max(is_smaller ? reach.left_alone : reach.in_groups, 1.0);
    if (!is_smaller && reach.in_groups <= longest_side) // nothing is cut
        return 1;
    const bool is_sensible = share * std::max(fitted.width, fitted.height) >= min_longer_side;
    return share < 1 && is_sensible ? share : 1;
}

}
