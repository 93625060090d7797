#include "tests/host/compiler/random_tracks.hpp"

#include "tests/host/compiler/random_keys.hpp"

namespace kfast::test {
namespace {

std::int32_t random_value(Dice& dice, Property property, std::size_t colours)
{
    switch (property) {
    case Property::rotation_x:
    case Property::rotation_y:
    case Property::rotation:
        return dice.within(-100'000, 100'000);
    case Property::scale_x:
    case Property::scale_y:
        return dice.within(-6000, 6000);
    case Property::along:
    case Property::trim_from:
    case Property::trim_to:
        return dice.within(0, path_whole);
    case Property::opacity:
        return dice.within(0, 255);
    case Property::visible:
        return dice.within(0, 1);
    case Property::trim_mode:
        return dice.within(0, max_trim_mode);
    case Property::max_dashes:
        return dice.within(1, max_dash_count);
    case Property::dash_1:
    case Property::gap_1:
    case Property::dash_2:
    case Property::gap_2:
    case Property::dash_3:
    case Property::gap_3:
        return dice.within(0, 2000);
    case Property::fill:
    case Property::stroke:
        return static_cast<std::int32_t>(dice.below(colours));
    case Property::width:
        return dice.within(0, 300);
    default:
        return dice.within(-3000, 3000);
    }
}

scene::Track random_track(Dice& dice, Property property, std::size_t colours)
{
    scene::Track track{property, {}, may_be_smooth(property) && dice.sometimes()};
    RisingTimes times{dice};
    const bool is_mode = property == Property::trim_mode || property == Property::max_dashes;
    const int most = is_mode ? 1 : 3; // it does not change
    for (int left = dice.within(1, most); left > 0; --left)
        track.keys.push_back({.time = times.next(),
                              .laws = random_laws(dice),
                              .value = random_value(dice, property, colours)});
    return track;
}

bool may_have(const scene::Object* object, Property property)
{
    switch (property) {
    case Property::fill:
        return object != nullptr && object->fill;
    case Property::stroke:
    case Property::width:
        return object != nullptr && object->stroke;
    case Property::trim_from:
    case Property::trim_to:
    case Property::trim_offset:
    case Property::trim_mode:
        return object != nullptr && !object->has_depths;
    default:
        return !is_of_dashes(property) || (object != nullptr && object->stroke && !object->has_depths);
    }
}

}

std::vector<scene::Track> random_tracks(Dice& dice, const scene::Object* object, std::size_t colours)
{
    std::vector<scene::Track> tracks;
    for (std::size_t number = 0; number < property_count; ++number) {
        const auto property = static_cast<Property>(number);
        if (may_have(object, property) && dice.below(6) == 0)
            tracks.push_back(random_track(dice, property, colours));
    }
    return tracks;
}

}
