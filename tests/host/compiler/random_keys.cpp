#include "tests/host/compiler/random_keys.hpp"

#include "core/time/spring_law.hpp"

#include <cstdint>

namespace kfast::test {
namespace {

VelocityLaw random_law(Dice& dice)
{
    const auto control = [&dice](int min, int max) {
        return static_cast<std::int16_t>(dice.within(min, max));
    };
    const auto x = [&] { return control(0, VelocityLaw::control_one); };
    const auto y = [&] { return control(VelocityLaw::lowest_y, VelocityLaw::highest_y); };
    const auto any = [&dice] { return static_cast<std::uint16_t>(dice.within(0, 65535)); };
    const auto end = [&dice] { return static_cast<SpringEnd>(dice.within(0, 2)); };
    switch (dice.within(0, 8)) {
    case 5:
        return VelocityLaw::in_steps(static_cast<std::uint16_t>(dice.within(1, 65535)));
    case 6: {
        const std::int16_t x1 = x();
        const std::int16_t y1 = y();
        const std::int16_t x2 = x();
        return VelocityLaw::bezier(x1, y1, x2, y());
    }
    case 7: {
        const auto bounces = static_cast<std::uint32_t>(dice.within(1, spring_count::max_bounces));
        return bounce_law(bounces, end());
    }
    case 8: {
        Oscillation numbers{.decay = any(), .turns = any()};
        numbers.lean = static_cast<std::int16_t>(any());
        numbers.size = static_cast<std::int16_t>(any());
        return spring_law(numbers, end());
    }
    default:
        return {.kind = static_cast<VelocityLaw::Kind>(dice.within(0, 4))};
    }
}

}

Time RisingTimes::next()
{
    const int step = dice_.within(is_first_ ? 0 : 1, 20);
    is_first_ = false;
    time_ = time_ + (dice_.sometimes() ? Time{step * 100} : Time::frame(step));
    return time_;
}

LawPair random_laws(Dice& dice)
{
    if (dice.sometimes())
        return {};
    const VelocityLaw x = random_law(dice);
    return {x, random_law(dice)};
}

LawPair soft_laws(Dice& dice)
{
    const VelocityLaw law{.kind = static_cast<VelocityLaw::Kind>(dice.within(0, 3))};
    return {law, law};
}

}
