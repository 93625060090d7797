#pragma once

#include <optional>
#include <string_view>

namespace kfast::svg {

/// The frame that the name of a layer tells: "12", "frame 12", "f 12", "f12: smile", "(s)0.5", "0.5s",
/// "500ms". Nothing where it tells none.
std::optional<double> layer_time(std::string_view name, double frame_rate);

}
