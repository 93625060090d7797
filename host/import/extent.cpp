#include "host/import/extent.hpp"

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
    for (const art::Rig& rig : document.rigs)
        count.add(rig);
    return count.extent();
}

}
