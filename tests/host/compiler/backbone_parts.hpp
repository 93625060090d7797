#pragma once

#include "host/compiler/carry/deformed_tweens.hpp"
#include "host/scene/model.hpp"

#include <cstdint>
#include <utility>
#include <vector>

/// Short ways to say what backbones there are.
namespace kfast::test {

/// A straight band of `segments` segments, 10 px long and 20 px wide, from (10, 30) to the right.
inline scene::Backbone straight_band(int segments)
{
    scene::Backbone backbone;
    for (int i = 0; i <= segments; ++i) {
        const auto x = static_cast<std::int16_t>(160 * (i + 1));
        backbone.nodes.push_back({x, 480});
        backbone.left.push_back({x, 320});
        backbone.right.push_back({x, 640});
    }
    return backbone;
}

/// The same, moved; in 1/16 px.
inline scene::Backbone moved(scene::Backbone backbone, int x, int y)
{
    for (auto* points : {&backbone.nodes, &backbone.left, &backbone.right})
        for (scene::Point& point : *points)
            point = {static_cast<std::int16_t>(point.x + x), static_cast<std::int16_t>(point.y + y)};
    return backbone;
}

inline scene::BackboneKey skeleton(int frame, std::vector<scene::Backbone> backbones)
{
    return {.time = Time::frame(frame), .laws = {}, .backbones = std::move(backbones), .place = {}};
}

inline scene::Object deformed(scene::Object object, std::vector<scene::BackboneKey> keys)
{
    object.backbone_keys = std::move(keys);
    return object;
}

}
