#pragma once

#include "host/geometry/shape.hpp"
#include "tests/host/art/random_document.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace kfast::test {

/// Random art whose channels have a key at every frame or so, most of which are of no use.
class CrowdedArt {
public:
    CrowdedArt(unsigned seed, bool depth) : random_{seed}, depth_{depth} {}

    art::Document document()
    {
        art::Document document;
        document.width = 240;
        document.height = 200;
        document.frames = 40;
        if (depth_)
            document.camera = 500;
        document.nodes.push_back(group(3));
        return document;
    }

private:
    art::Channel channel(double low, double high)
    {
        if (random_.chance(0.4))
            return random_.number(low, high);
        const double middle = (low + high) / 2;
        art::Channel channel = random_.channel(0, 40, (high - low) / 6);
        for (auto& key : channel.keys)
            key.value += middle;
        channel = random_.crowded(channel, 0);
        return random_.crowded(channel, random_.chance(0.5) ? 1e-5 * (high - low) : 0);
    }

    art::Transform transform()
    {
        art::Transform transform;
        transform.anchor_x = channel(-20, 20);
        transform.anchor_y = channel(-20, 20);
        transform.x = channel(-60, 60);
        transform.y = channel(-60, 60);
        transform.scale_x = channel(0.2, 2);
        transform.scale_y = channel(0.2, 2);
        transform.rotate = channel(-200, 200);
        if (random_.chance(0.2))
            transform.skew = random_.number(-30, 30);
        if (depth_) {
            transform.rotate_x = channel(-50, 50);
            transform.rotate_y = channel(-50, 50);
            transform.z = channel(-40, 40);
        }
        return transform;
    }

    art::Drawing drawing(scene::Vec2 shift)
    {
        scene::Outline outline = scene::ellipse(scene::Vec2{30, 20} + shift, 40, 25);
        outline.curves[1].c2 = outline.curves[1].c2 + shift;
        return {{outline}};
    }

    art::Node shape()
    {
        art::Shape shape;
        constexpr int count = 30;
        std::vector<art::Key<art::Drawing>> keys;
        keys.reserve(count);
        for (int i = 0; i < count; ++i)
            keys.push_back({1.25 * i, drawing({10 * std::sin(0.15 * i), random_.number(0, 0.01)}), {}});
        if (random_.chance(0.5))
            keys.resize(1);
        shape.drawing = art::Animated<art::Drawing>{std::move(keys)};
        shape.fill.emplace();
        art::Node node;
        node.content = std::move(shape);
        return named(std::move(node));
    }

    art::Node group(int depth)
    {
        art::Group group;
        for (int i = random_.integer(1, 2); i > 0; --i)
            group.nodes.push_back(depth > 0 && random_.chance(0.7) ? this->group(depth - 1) : shape());
        art::Node node;
        node.content = std::move(group);
        return named(std::move(node));
    }

    art::Node named(art::Node node)
    {
        node.name = std::to_string(next_name_++);
        node.transform = transform();
        return node;
    }

    RandomArt random_;
    bool depth_;
    int next_name_ = 0;
};

}
