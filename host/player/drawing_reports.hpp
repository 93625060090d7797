#pragma once

#include "firmware/link/report.hpp"
#include "host/player/received_drawing.hpp"

#include <cstdint>
#include <vector>

namespace kfast {

/// The reports that tell a device a live drawing, in their order (docs/link.md, "Live drawings"). `number`
/// tells it from the ones before, modulo 8: one more for each drawing of this input. With the tag 0 nothing
/// answers them but errors.
std::vector<link::Report> drawing_reports(const ReceivedDrawing& drawing, std::uint8_t input,
                                          std::uint8_t number, std::uint8_t tag = 0);

}
