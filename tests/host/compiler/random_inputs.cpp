#include "tests/host/compiler/random_inputs.hpp"

#include "tests/host/compiler/random_drawing.hpp"

#include <algorithm>

namespace kfast::test {
namespace {

scene::Input random_number_input(Dice& dice)
{
    const int min = dice.within(-90'000, 90'000);
    const int max = dice.within(min + 1, 100'000);
    return {dice.name(), min, max, dice.within(min, max)};
}

scene::Input random_drawing_input(Dice& dice)
{
    scene::Drawing default_value = random_drawing(dice);
    for (scene::Stroke& stroke : default_value.strokes)
        std::erase_if(stroke.segments, [](const scene::Segment& segment) { return segment.cubic; });
    const std::size_t points = std::max<std::size_t>(point_count(default_value), 1) + dice.below(4);
    const std::size_t strokes = std::max<std::size_t>(default_value.strokes.size(), 1);
    return {.name = dice.name(),
            .type = InputType::drawing,
            .drawing = {.strokes = strokes, .points = points, .default_value = std::move(default_value)}};
}

template <class Key>
bool lie_on_input(const std::vector<Key>& keys)
{
    return keys.empty() || keys.back().time <= whole_input;
}

/// Inputs as they lie in a scene: texts, then numbers, then drawings.
class Inputs {
public:
    Inputs(Dice& dice, std::vector<scene::Input>& inputs) : dice_{dice}, texts_{inputs.size()}
    {
        for (scene::Input& text : inputs)
            text.name = dice_.name();
        for (int left = dice_.within(-3, 3); left > 0; --left)
            inputs.push_back(random_number_input(dice_));
        numbers_ = inputs.size() - texts_;
        for (int left = dice_.within(-2, 2); left > 0; --left)
            inputs.push_back(random_drawing_input(dice_));
        drawings_ = inputs.size() - numbers_ - texts_;
    }

    void bind(std::vector<scene::Bone>& bones)
    {
        for (scene::Bone& bone : bones)
            if (std::ranges::all_of(bone.keys, lie_on_input<scene::TrackKey>))
                bone.driver = any_driver();
    }

    void bind(std::vector<scene::Item>& items)
    {
        for (scene::Item& item : items) {
            for (scene::Track& track : item.tracks)
                if (lie_on_input(track.keys))
                    track.driver = any_driver();
            if (auto* group = std::get_if<scene::Group>(&item.content))
                bind(group->items);
            else if (auto* object = std::get_if<scene::Object>(&item.content))
                bind(*object);
        }
    }

private:
    void bind(scene::Object& object)
    {
        if (drawings_ != 0 && !object.label && dice_.sometimes()) {
            object.keys.clear();
            object.skin = {};
            object.backbone_keys.clear();
            object.has_depths = false;
            object.live = texts_ + numbers_ + dice_.below(drawings_);
        } else if (object.keys.size() > 1 && lie_on_input(object.keys) &&
                   lie_on_input(object.backbone_keys)) {
            object.driver = any_driver();
        }
    }

    /// The time, or a number.
    Driver any_driver()
    {
        const std::size_t driver = dice_.below(numbers_ + 1);
        return {static_cast<std::uint8_t>(driver == 0 ? 0 : texts_ + driver)};
    }

    Dice& dice_;
    std::size_t texts_;
    std::size_t numbers_ = 0;
    std::size_t drawings_ = 0;
};

}

void add_random_inputs(Dice& dice, scene::Scene& scene)
{
    Inputs inputs{dice, scene.inputs};
    for (scene::Bones& skeleton : scene.bones)
        inputs.bind(skeleton.bones);
    for (scene::Symbol& symbol : scene.symbols)
        inputs.bind(symbol.items);
    inputs.bind(scene.items);
}

}
