#pragma once

#include "core/time/time.hpp"
#include "host/player/received_drawing.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace kfast {

/// What inputs of a scene are to be from now on, by their numbers.
struct LiveValues {
    std::map<std::uint8_t, Time> places = {}; ///< of numbers: 0 … whole_input
    std::map<std::uint8_t, std::string> texts = {};
    std::map<std::uint8_t, ReceivedDrawing> drawings = {};

    bool empty() const { return places.empty() && texts.empty() && drawings.empty(); }
    /// What is newer takes the place of what is here.
    void take(LiveValues newer)
    {
        newer.places.merge(places);
        newer.texts.merge(texts);
        newer.drawings.merge(drawings);
        *this = std::move(newer);
    }

    friend bool operator==(const LiveValues&, const LiveValues&) = default;
};

}
