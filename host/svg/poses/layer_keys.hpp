#pragma once

#include "host/svg/poses/key_options.hpp"
#include "host/svg/poses/pose_document.hpp"

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::svg {

/// The frame that the name of a layer gives: "12", "frame 12", "f 12", "f12: smile", "(s)0.5", "0.5s",
/// "500ms". Nothing if it gives none.
std::optional<double> layer_time(std::string_view name, double frame_rate);

/// A layer that is a key drawing.
struct KeyLayer {
    pugi::xml_node element;
    std::string name;
    double time = 0; ///< in frames
};

/// The outermost layers of a drawing that are named by a frame, in the order of their times; none if these
/// are fewer than two, or not requested. Throws Failure if they are requested and too few, or have the same
/// time.
std::vector<KeyLayer> key_layers(pugi::xml_node root, const KeyOptions& options);

/// The drawing at the time of each of these layers: with it, without the others, and with all else. It is
/// placed where the lowest of them is.
std::vector<Pose> poses_of(const Part& root, const std::vector<KeyLayer>& layers, const KeyOptions& options);

}
