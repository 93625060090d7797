#pragma once

#include "firmware/settings/panel_settings.hpp"
#include "host/picture/frame_source.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace kfast {

/// What a board with such a panel shows: the firmware sends to the simulator what differs from the picture
/// before, and the pictures are decoded from the bytes on its bus. show() throws Failure for a mistake there.
///
/// `scene` is a checked scene and must outlive the source.
std::unique_ptr<FrameSource> open_board_source(std::span<const std::byte> scene,
                                               const PanelSettings& settings);

}
