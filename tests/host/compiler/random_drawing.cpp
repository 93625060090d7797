#include "tests/host/compiler/random_drawing.hpp"

#include <cstdint>

namespace kfast::test {

scene::Point random_point(Dice& dice)
{
    const auto x = static_cast<std::int16_t>(dice.within(-1600, 3200));
    return {x, static_cast<std::int16_t>(dice.within(-1600, 3200))};
}

std::vector<scene::Point> random_points(Dice& dice, int count)
{
    std::vector<scene::Point> points;
    for (; count > 0; --count)
        points.push_back(random_point(dice));
    return points;
}

scene::Segment random_segment(Dice& dice)
{
    if (dice.sometimes())
        return {.cubic = true, .c1 = random_point(dice), .c2 = random_point(dice), .to = random_point(dice)};
    return {.cubic = false, .c1 = {}, .c2 = {}, .to = random_point(dice)};
}

scene::Drawing random_drawing(Dice& dice, int strokes)
{
    scene::Drawing drawing;
    drawing.strokes.resize(static_cast<std::size_t>(strokes));
    for (scene::Stroke& stroke : drawing.strokes) {
        stroke.from = random_point(dice);
        for (int left = dice.within(0, 5); left > 0; --left)
            stroke.segments.push_back(random_segment(dice));
        if (dice.sometimes() && stroke.segments.size() > 1)
            stroke.segments.back().to = stroke.from;
    }
    return drawing;
}

scene::Drawing random_drawing(Dice& dice) { return random_drawing(dice, dice.within(0, 3)); }

scene::Drawing random_curves(Dice& dice)
{
    const auto near = [&dice] {
        const auto x = static_cast<std::int16_t>(dice.within(-960, 960));
        return scene::Point{x, static_cast<std::int16_t>(dice.within(-960, 960))};
    };
    scene::Stroke stroke{.from = near(), .segments = {}};
    for (int left = dice.within(1, 4); left > 0; --left) {
        const scene::Point c1 = near();
        const scene::Point c2 = near();
        stroke.segments.push_back({.cubic = true, .c1 = c1, .c2 = c2, .to = near()});
    }
    return {{stroke}};
}

}
