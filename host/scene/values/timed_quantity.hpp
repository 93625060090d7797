#pragma once

#include "host/scene/model.hpp"

#include <algorithm>
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

/// The path that one of them leads along, which then has none.
inline std::optional<Path> take_path(std::span<TimedQuantity> quantities)
{
    for (TimedQuantity& quantity : quantities)
        if (quantity.path)
            return std::exchange(quantity.path, std::nullopt);
    return std::nullopt;
}

}
