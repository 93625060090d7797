#pragma once

#include "host/art/losses.hpp"
#include "host/lottie/values/channel.hpp"

#include <string>
#include <vector>

namespace kfast::lottie {

/// What reading goes along with, from layer to layer.
struct Reading {
    art::Budget& budget;
    art::Losses& losses;
    LayerTime time;
    std::string layer; ///< for losses: "body / arm"
    int depth = 0;     ///< of layers and groups around
};

/// What a shape layer draws: its "shapes", the lowest of the result first.
std::vector<art::Node> read_shapes(const Json& shapes, const Reading& reading);

/// "ks" of a layer or "tr" of a group, without its opacity "o".
art::Transform read_transform(const Json& transform, const Reading& reading);

}
