#pragma once

#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"
#include "tests/host/compiler/dice.hpp"

namespace kfast::test {

/// When keys lie, one after the other.
class RisingTimes {
public:
    explicit RisingTimes(Dice& dice) : dice_{dice} {}

    Time next();

private:
    Dice& dice_;
    Time time_;
    bool is_first_ = true;
};

/// Of the way to the next key.
LawPair random_laws(Dice& dice);

/// The same for x and y: even or softened speed.
LawPair soft_laws(Dice& dice);

}
