#include "host/art/document/every_animation.hpp"
#include "host/art/prepare/prepare.hpp"

namespace kfast::art {
namespace {

using scene::Outline;
using scene::Vec2;

/// Multiplies lengths and places, at any time.
class Growth {
public:
    explicit Growth(double factor) : factor_{factor} {}

    void operator()(double& length) const { length *= factor_; }
    void operator()(Vec2& spot) const { spot = factor_ * spot; }

    void operator()(Outline& outline) const
    {
        (*this)(outline.from);
        for (scene::Curve& curve : outline.curves)
            for (Vec2* spot : {&curve.c1, &curve.c2, &curve.to})
                (*this)(*spot);
    }

    void operator()(Drawing& drawing) const
    {
        for (Outline& outline : drawing.outlines)
            (*this)(outline);
    }

    template <typename Value>
    void operator()(Animated<Value>& animated) const
    {
        for (auto& key : animated.keys)
            (*this)(key.value);
    }

    void operator()(Transform& transform) const
    {
        for (Channel* channel :
             {&transform.anchor_x, &transform.anchor_y, &transform.x, &transform.y, &transform.z})
            (*this)(*channel);
        if (transform.path)
            (*this)(transform.path->path);
    }

    void operator()(Node& node) const
    {
        (*this)(node.transform);
        if (auto* shape = std::get_if<Shape>(&node.content)) {
            (*this)(shape->drawing);
            if (shape->stroke)
                (*this)(shape->stroke->width);
        }
    }

    void operator()(Bone& bone) const
    {
        (*this)(bone.from);
        (*this)(bone.to);
        (*this)(bone.x);
        (*this)(bone.y);
        if (bone.length)
            (*this)(*bone.length);
    }

private:
    double factor_;
};

}

void scale(Document& document, double factor)
{
    const Growth grow{factor};
    grow(document.width);
    grow(document.height);
    if (document.camera)
        grow(*document.camera);
    every_node(document.nodes, [&](Node& node, const std::string&) { grow(node); });
    for (Rig& rig : document.rigs)
        for (Bone& bone : rig.bones)
            grow(bone);
}

}
