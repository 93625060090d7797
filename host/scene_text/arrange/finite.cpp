#include "host/program/failure.hpp"
#include "host/scene_text/arrange/arrange.hpp"

#include <cmath>
#include <string>

namespace kfast::scene_text {
namespace {

/// Checks every number; messages about those of a node give its name.
class Finite {
public:
    void check(const art::Document& document)
    {
        for (const double number : {document.width, document.height, document.frame_rate, document.frames,
                                    document.camera.value_or(0)})
            check(number);
        if (document.background)
            check(*document.background);
        for (const art::Marker& marker : document.markers) {
            check(marker.time);
            check(marker.duration);
        }
        for (const art::Rig& rig : document.rigs)
            for (const art::Bone& bone : rig.bones)
                check(bone);
        check(document.nodes);
        for (const art::Symbol& symbol : document.symbols) {
            check(symbol.frames);
            check(symbol.nodes);
        }
    }

private:
    void check(double number) const
    {
        if (!std::isfinite(number))
            throw Failure("a number is infinite or too large" +
                          (name_.empty() ? "" : " in \"" + name_ + '"') + "; make the drawing smaller");
    }

    void check(scene::Vec2 spot) const
    {
        check(spot.x);
        check(spot.y);
    }

    void check(const art::Rgb& colour) const
    {
        for (const double channel : {colour.red, colour.green, colour.blue})
            check(channel);
    }

    void check(const art::Drawing& drawing) const
    {
        for (const scene::Outline& outline : drawing.outlines) {
            check(outline.from);
            for (const scene::Curve& curve : outline.curves) {
                check(curve.c1);
                check(curve.c2);
                check(curve.to);
            }
        }
    }

    template <typename Value>
    void check(const art::Animated<Value>& animated) const
    {
        for (const auto& key : animated.keys) {
            check(key.time);
            check(key.value);
            for (const double control : {key.ease.x1, key.ease.y1, key.ease.x2, key.ease.y2})
                check(control);
        }
    }

    void check(const art::Bone& bone) const
    {
        check(bone.from);
        check(bone.to);
        for (const art::Channel* channel : {&bone.rotation, &bone.x, &bone.y})
            check(*channel);
        if (bone.length)
            check(*bone.length);
    }

    void check(const art::Transform& transform) const
    {
        for (const art::Channel* channel :
             {&transform.anchor_x, &transform.anchor_y, &transform.x, &transform.y, &transform.z,
              &transform.scale_x, &transform.scale_y, &transform.rotate, &transform.rotate_x,
              &transform.rotate_y, &transform.skew, &transform.skew_axis})
            check(*channel);
        if (!transform.path)
            return;
        check(transform.path->path);
        check(transform.path->share);
    }

    void check(const art::Shape& shape) const
    {
        check(shape.drawing);
        if (shape.fill) {
            check(shape.fill->colour);
            check(shape.fill->opacity);
        }
        if (shape.stroke) {
            check(shape.stroke->colour);
            check(shape.stroke->opacity);
            check(shape.stroke->width);
            for (const art::Channel& length : shape.stroke->dashes.lengths)
                check(length);
            check(shape.stroke->dashes.offset);
            check(shape.stroke->miter_limit);
        }
        if (shape.skin)
            for (const auto& point : shape.skin->points)
                for (const art::BoneInfluence& share : point)
                    check(share.weight);
    }

    void check(const art::Use& use) const
    {
        const art::Copies& copies = use.copies;
        for (const double number :
             {use.delay, use.speed, copies.x, copies.y, copies.rotation, copies.scale, copies.opacity})
            check(number);
    }

    void check(const std::vector<art::Node>& nodes)
    {
        for (const art::Node& node : nodes) {
            if (!node.name.empty())
                name_ = node.name;
            check(node.transform);
            check(node.opacity);
            if (const auto* const group = std::get_if<art::Group>(&node.content))
                check(group->nodes);
            else if (const auto* const use = std::get_if<art::Use>(&node.content))
                check(*use);
            else
                check(std::get<art::Shape>(node.content));
        }
    }

    std::string name_ = {};
};

}

void check_finite(const art::Document& document) { Finite{}.check(document); }

}
