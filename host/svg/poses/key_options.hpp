#pragma once

#include "host/art/animation/ease.hpp"

#include <cstdint>

namespace kfast::svg {

/// What comes after the last key drawing. It is there for one frame, unless the scene goes on with the first
/// one and that looks the same.
enum class Ending : std::uint8_t {
    /// What runs on without a jump: repeat if the last drawing looks like the first, else ping_pong.
    automatic,
    once,          ///< it stays
    repeat,        ///< the first one, at once
    ping_pong,     ///< the same way back
    back_to_first, ///< the first one, after a way as long as the one to the last
};

/// Layers of one drawing as its keys: those named by a frame, "12", "frame 12", "f 12: smile", or by a time,
/// "0.5s" or "(s)0.5".
enum class LayerKeys : std::uint8_t {
    automatic, ///< where at least two layers are named so
    always,    ///< Failure where fewer are
    never,
};

/// How drawings become keys.
struct KeyOptions {
    double frame_rate = 30; ///< frames per second, above 0
    art::Ease ease = {};    ///< of the way from each drawing to the next
    Ending ending = Ending::automatic;
    LayerKeys layers = LayerKeys::automatic;
    friend bool operator==(const KeyOptions&, const KeyOptions&) = default;
};

}
