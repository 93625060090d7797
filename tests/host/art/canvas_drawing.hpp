#pragma once

#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace kfast::test {

/// A place in space: pixels, z towards the viewer.
struct SourceSpan {
    double x = 0;
    double y = 0;
    double z = 0;
};

/// What a transform that is still makes of a place of a node's content, as docs/scene-language.md and
/// host/art/document/document.hpp have it.
inline SourceSpan placed(const art::Transform& transform, SourceSpan place)
{
    const auto radians = [&](const art::Channel& degrees) {
        return degrees.value() * std::numbers::pi / 180;
    };
    const auto turn = [](double& from, double& to, double angle) {
        const double begin = from;
        from = begin * std::cos(angle) - to * std::sin(angle);
        to = begin * std::sin(angle) + to * std::cos(angle);
    };
    place.x -= transform.anchor_x.value();
    place.y -= transform.anchor_y.value();
    turn(place.x, place.y, -radians(transform.skew_axis));
    place.x += place.y * std::tan(-radians(transform.skew));
    turn(place.x, place.y, radians(transform.skew_axis));
    place.x *= transform.scale_x.value();
    place.y *= transform.scale_y.value();
    turn(place.x, place.y, radians(transform.rotate));
    turn(place.z, place.x, radians(transform.rotate_y));
    turn(place.y, place.z, radians(transform.rotate_x));
    return {place.x + transform.x.value(), place.y + transform.y.value(), place.z + transform.z.value()};
}

/// The drawings of a document on its canvas at a moment, by the names of their nodes.
class CanvasDrawings {
public:
    CanvasDrawings(const art::Document& document, double time) : document_{document}, time_{time}
    {
        draw(document.nodes, {});
    }

    const std::map<std::string, art::Drawing>& drawings() const { return drawings_; }

private:
    using Way = std::vector<art::Transform>;

    art::Transform now(art::Transform transform) const
    {
        art::every_animation(transform, [&](art::Channel& channel) { channel = channel.at(time_); });
        return transform;
    }

    void draw(const std::vector<art::Node>& nodes, const Way& around)
    {
        for (const art::Node& node : nodes) {
            Way way = around;
            way.push_back(now(node.transform));
            if (const auto* group = std::get_if<art::Group>(&node.content))
                draw(group->nodes, way);
            else
                drawings_[node.name] = on_canvas(std::get<art::Shape>(node.content).drawing.at(time_), way);
        }
    }

    art::Drawing on_canvas(art::Drawing drawing, const Way& way) const
    {
        for (scene::Outline& outline : drawing.outlines) {
            // Perspective bends nothing of a line, but moves along it: compared are the control points.
            scene::Vec2 from = outline.from;
            for (scene::Curve& curve : outline.curves) {
                curve = art::as_cubic(from, curve);
                from = curve.to;
                for (scene::Vec2* spot : {&curve.c1, &curve.c2, &curve.to})
                    *spot = seen(*spot, way);
            }
            outline.from = seen(outline.from, way);
        }
        return drawing;
    }

    scene::Vec2 seen(scene::Vec2 spot, const Way& way) const
    {
        SourceSpan place{spot.x, spot.y, 0};
        for (auto transform = way.rbegin(); transform != way.rend(); ++transform)
            place = placed(*transform, place);
        if (!document_.camera)
            return {place.x, place.y};
        const double camera = *document_.camera;
        const double scale_factor = camera / (camera - std::min(place.z, camera * 15 / 16));
        const scene::Vec2 middle{document_.width / 2, document_.height / 2};
        return middle + scale_factor * (scene::Vec2{place.x, place.y} - middle);
    }

    const art::Document& document_;
    double time_;
    std::map<std::string, art::Drawing> drawings_;
};

}
