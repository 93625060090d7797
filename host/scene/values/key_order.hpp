#pragma once

#include "core/time/time.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/values/key_driver.hpp"

#include <string_view>

/// What keys that stand in the order of their moments have in common.
namespace kfast::scene {

/// Where and when something is.
struct PlacedMoment {
    Time time;
    SourceSpan place;
};

/// Whether `at`, a `noun` such as "key", is later than `before` on their `driver`, and reports it if not.
bool comes_later(std::string_view noun, PlacedMoment before, PlacedMoment at, const KeyDriver& driver,
                 SceneContext& context);

}
