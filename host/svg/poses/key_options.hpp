#pragma once

#include "host/art/animation/ease.hpp"

#include <cstdint>

namespace kfast::svg {

/// What comes after the last key drawing. It is there for one frame, unless the scene goes on with the first
/// one and that looks the same.
enum class Ending : std::uint8_t {
    /// The one without a jump: repeat if the last drawing looks like the first, else ping_pong.
    automatic,
    once,          ///< it stays
    repeat,        ///< the first one, at once
    ping_pong,     ///< back by the same drawings
    back_to_first, ///< the first one, after as long a transition as that to the last
};

/// Whether layers of one drawing are its keys: those named by a frame, "12", "frame 12", "f 12: smile", or by
/// a time, "0.5s" or "(s)0.5".
enum class LayerKeys : std::uint8_t {
    automatic, ///< if at least two layers have such names
    always,    ///< Failure where fewer are
    never,
};

/// How drawings become keys.
struct KeyOptions {
    double frame_rate = 30; ///< frames per second, above 0
    art::Ease ease = {};    ///< from each drawing to the next
    Ending ending = Ending::automatic;
    LayerKeys layers = LayerKeys::automatic;
    friend bool operator==(const KeyOptions&, const KeyOptions&) = default;
};

}
