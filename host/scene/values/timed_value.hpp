#pragma once

#include "core/scene/property.hpp"
#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/schema/node_schema.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene {

inline constexpr std::string_view at_name = "at";

/// A node `at` of a track: a value, and the law of the way to the next.
struct TimedValue {
    const kdl::Node* node = nullptr;
    Time time;
    std::int32_t value = 0; ///< in the unit of its property
    std::optional<VelocityLaw> law;
    SourceSpan place; ///< of the node's name and both values
};

/// Those that stand in `track`, in the order of their times on its clock, which all differ; without those
/// that are wrong, which are reported.
std::vector<TimedValue> read_timed_values(const kdl::Node& track, Property property, const KeyDriver& driver,
                                          SceneContext& context);

NodeSchema at_words();

}
