#pragma once

#include "core/scene/property.hpp"
#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/schema/node_form.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::scene {

/// A quantity of an item that goes by key times: what a node `track` says.
struct TimedQuantity {
    std::string_view name;     ///< as it is written
    SourceSpan place;          ///< of the node's name and the quantity
    std::vector<Track> tracks; ///< one; of `scale` one for each axis. No keys where they are wrong
    std::optional<Path> path;  ///< of `along`, unless it is wrong
};

inline bool gives(const TimedQuantity& quantity, Property property)
{
    return std::ranges::find(quantity.tracks, property, &Track::property) != quantity.tracks.end();
}

inline Track* find_track(std::span<TimedQuantity> quantities, Property property)
{
    for (TimedQuantity& quantity : quantities)
        for (Track& track : quantity.tracks)
            if (track.property == property)
                return &track;
    return nullptr;
}

/// Takes the path from the one of them that has it.
inline std::optional<Path> take_path(std::span<TimedQuantity> quantities)
{
    for (TimedQuantity& quantity : quantities)
        if (quantity.path)
            return std::exchange(quantity.path, std::nullopt);
    return std::nullopt;
}

inline constexpr std::string_view at_name = "at";

/// A node `at` of a track: a value, and the law to the next.
struct TimedValue {
    const kdl::Node* node = nullptr;
    Time time;
    std::int32_t value = 0; ///< in the unit of its property
    std::optional<VelocityLaw> law;
    SourceSpan place; ///< of the node's name and both values
};

/// The values in `track`, in the order of their times by its driver, which all differ; without those that
/// are wrong, which are reported.
std::vector<TimedValue> read_timed_values(const kdl::Node& track, Property property, const KeyDriver& driver,
                                          SceneContext& context);

NodeSchema at_schema();

}
