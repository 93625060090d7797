#pragma once

#include "host/art/document/document.hpp"
#include "tests/host/art/random_document.hpp"

#include <string>

namespace kfast::test {

/// Documents of groups and fills that do everything that nodes in the plane can do.
class RandomScene {
public:
    static constexpr double size = 64;
    static constexpr double frames = 40;

    explicit RandomScene(unsigned seed) : random_{seed} {}

    art::Document document(int depth)
    {
        art::Document result;
        result.width = size;
        result.height = size;
        result.frames = frames;
        result.loop = Loop::once;
        for (int i = random_.integer(1, 3); i > 0; --i)
            result.nodes.push_back(node(depth));
        return result;
    }

private:
    /// Mostly still.
    art::Channel channel(double low, double high, double default_value)
    {
        if (random_.chance(0.4))
            return {default_value};
        const double middle = (low + high) / 2;
        if (random_.chance(0.5))
            return {random_.number(low, high)};
        art::Channel channel = random_.channel(0, frames, (high - low) / 2);
        for (auto& key : channel.keys) {
            key.value += middle;
            if (random_.chance(0.1))
                key.ease = {art::EaseKind::cubic, 0.3, -3, 0.6, 4.5};
        }
        return channel.keys.empty() ? art::Channel{default_value} : channel;
    }

    /// What grows much, nested in what does, shows that coordinates are rounded.
    static void tame(art::Channel& channel)
    {
        for (auto& key : channel.keys) {
            key.ease.y1 = std::clamp(key.ease.y1, -0.5, 1.5);
            key.ease.y2 = std::clamp(key.ease.y2, -0.5, 1.5);
        }
    }

    art::Transform transform()
    {
        art::Transform transform;
        transform.x = channel(20, 44, 32);
        transform.y = channel(20, 44, 32);
        if (random_.chance(0.3)) { // keys in common
            transform.y = transform.x;
            for (auto& key : transform.y.keys)
                key.value = random_.number(20, 44);
        }
        transform.anchor_x = channel(20, 44, 32);
        transform.anchor_y = channel(20, 44, 32);
        transform.rotate = channel(-200, 200, 0);
        transform.scale_x = channel(0.6, 1.4, 1);
        transform.scale_y = random_.chance(0.5) ? transform.scale_x : channel(0.6, 1.4, 1);
        tame(transform.scale_x);
        tame(transform.scale_y);
        if (random_.chance(0.15))
            for (auto& key : transform.scale_x.keys)
                key.value *= -1;
        if (random_.chance(0.2)) {
            transform.skew = channel(-40, 40, 20);
            for (auto& key : transform.skew.keys) // not beyond a quarter turn
                key.ease.y1 = key.ease.y2 = 0.5;
            transform.skew_axis = {random_.number(-90, 90)};
        }
        if (random_.chance(0.15))
            transform.path = art::MotionPath{
                {{{{32, 20}, {scene::cubic_to({50, 20}, {50, 40}, {32, 44})}, false}}}, channel(0, 1, 0.5)};
        return transform;
    }

    scene::Outline outline(int curves, bool cubic)
    {
        const auto spot = [&] { return scene::Vec2{32, 32} + random_.spot(22); };
        scene::Outline outline{spot(), {}, true};
        for (int i = 0; i < curves; ++i)
            outline.curves.push_back(cubic ? scene::cubic_to(spot(), spot(), spot())
                                           : scene::line_to(spot()));
        if (random_.chance(0.5))
            outline.curves.back().to = outline.from;
        if (random_.chance(0.2)) // a segment without length
            outline.curves.front() = scene::line_to(outline.from);
        return outline;
    }

    art::Shape shape()
    {
        art::Shape shape;
        const int curves = random_.integer(3, 6);
        const bool cubic = random_.chance(0.5);
        std::vector<art::Key<art::Drawing>> keys;
        for (const double time : random_.times(0, frames))
            if (keys.size() < 3)
                keys.push_back({time, {{outline(curves, cubic)}}, random_.ease()});
        if (random_.chance(0.5))
            keys.resize(1);
        shape.drawing = art::Animated<art::Drawing>{std::move(keys)};
        const int colour = random_.integer(0, 2);
        shape.fill = art::Fill{{{colour == 0 ? 1.0 : 0, colour == 1 ? 1.0 : 0, colour == 2 ? 1.0 : 0}},
                               {1},
                               random_.chance(0.5) ? FillRule::nonzero : FillRule::even_odd};
        return shape;
    }

    art::Node node(int depth)
    {
        art::Node node;
        node.name = random_.chance(0.5) ? "node" : "";
        if (random_.chance(0.6))
            node.transform = transform();
        if (random_.chance(0.2))
            node.shown = {{random_.number(-5, 20), random_.number(20, 50)}};
        if (depth == 0 || random_.chance(0.2)) {
            node.content = shape();
            return node;
        }
        art::Group group;
        for (int i = random_.integer(1, 2); i > 0; --i)
            group.nodes.push_back(this->node(depth - 1));
        node.content = std::move(group);
        return node;
    }

    RandomArt random_;
};

}
