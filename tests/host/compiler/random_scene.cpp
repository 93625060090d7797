#include "tests/host/compiler/random_scene.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/host/compiler/random_drawing.hpp"
#include "tests/host/compiler/random_inputs.hpp"
#include "tests/host/compiler/random_keys.hpp"
#include "tests/host/compiler/random_object.hpp"
#include "tests/host/compiler/random_skeleton.hpp"
#include "tests/host/compiler/random_skin.hpp"
#include "tests/host/compiler/random_tracks.hpp"

#include <algorithm>

namespace kfast::test {
namespace {

Loop random_loop(Dice& dice) { return static_cast<Loop>(dice.below(3)); }

scene::Path random_path(Dice& dice)
{
    scene::Path path{{random_point(dice), {}}, dice.sometimes()};
    for (int left = dice.within(1, 3); left > 0; --left)
        path.stroke.segments.push_back(random_segment(dice));
    return path;
}

class SceneMaker {
public:
    explicit SceneMaker(Dice& dice) : dice_{dice} {}

    scene::Scene scene()
    {
        make_canvas();
        for (int left = dice_.within(0, 2); left > 0; --left)
            scene_.bones.push_back({dice_.name(), random_bones(dice_), {}});
        for (int left = dice_.within(0, 3); left > 0; --left) {
            scene::Symbol symbol{dice_.name(), items(1)};
            scene_.symbols.push_back(std::move(symbol));
        }
        scene_.items = items(2);
        make_marks();
        add_random_inputs(dice_, scene_);
        return std::move(scene_);
    }

private:
    void make_canvas()
    {
        scene_.canvas = {static_cast<std::int16_t>(dice_.within(1, 300)),
                         static_cast<std::int16_t>(dice_.within(1, 300))};
        scene_.frame_rate = static_cast<std::uint32_t>(dice_.within(1, 1'000'000));
        scene_.length = {dice_.within(1024, 100'000)};
        scene_.loop = random_loop(dice_);
        scene_.camera = dice_.within(kfb::min_camera, 1000);
        for (int left = dice_.within(1, 5); left > 0; --left)
            scene_.palette.push_back({dice_.byte(), dice_.byte(), dice_.byte(), dice_.byte()});
        scene_.palette.front().opacity = 255;
    }

    std::vector<scene::Item> items(int levels)
    {
        std::vector<scene::Item> items;
        for (int left = dice_.within(0, 3); left > 0; --left)
            items.push_back(item(levels));
        return items;
    }

    scene::Item item(int levels)
    {
        scene::Item item{.name = "i", .tracks = {}, .content = scene::Group{}, .place = {}};
        if (levels > 0 && dice_.sometimes())
            item.content = scene::Group{items(levels - 1)};
        else if (!scene_.symbols.empty() && dice_.sometimes())
            item.content = scene::Use{dice_.below(scene_.symbols.size())};
        else
            item.content = random_object(dice_, scene_);
        item.tracks = random_tracks(dice_, std::get_if<scene::Object>(&item.content), scene_.palette.size());
        if (std::ranges::find(item.tracks, Property::along, &scene::Track::property) != item.tracks.end())
            item.path = random_path(dice_);
        return item;
    }

    void make_marks()
    {
        for (int left = dice_.within(0, 3); left > 0; --left) {
            const int begin = dice_.within(0, scene_.length.ticks - 1);
            scene_.clips.push_back(
                {dice_.name(), {begin}, {dice_.within(begin + 1, scene_.length.ticks)}, random_loop(dice_)});
        }
        for (int left = dice_.within(0, 3); left > 0; --left)
            scene_.events.push_back({dice_.name(), {dice_.within(0, scene_.length.ticks)}});
        std::ranges::sort(scene_.events, {}, &scene::Event::time);
    }

    Dice& dice_;
    scene::Scene scene_;
};

}

scene::Scene random_scene(std::mt19937& random)
{
    Dice dice{random};
    return SceneMaker{dice}.scene();
}

scene::Scene random_deformed_scene(std::mt19937& random)
{
    Dice dice{random};
    scene::Scene scene;
    scene.canvas = {240, 240};
    scene.length = Time::frame(40);
    scene.palette = {{0, 0, 0}};
    scene.bones.push_back({dice.name(), moderate_bones(dice), {}});
    scene::Object object;
    object.fill = 0;
    RisingTimes times{dice};
    for (int left = dice.within(1, 3); left > 0; --left)
        object.keys.push_back(
            {.time = times.next(), .laws = soft_laws(dice), .drawing = random_curves(dice), .place = {}});
    object.skin = random_skin(dice, scene.bones, 0, object.keys.front().drawing);
    scene.items.push_back({.name = "i", .tracks = {}, .content = object, .place = {}});
    return scene;
}

}
