#pragma once

#include "core/pose/scene_state.hpp"
#include "firmware/settings/panel_settings.hpp"
#include "host/picture/timeline.hpp"
#include "host/wired/panel_lines.hpp"
#include "host/wired/spi_device.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace kfast {

/// What a display that is wired to this computer is to show.
struct PanelShow {
    PanelSettings panel;
    std::span<const std::byte> scene; ///< checked
    Timeline timeline;
    std::function<void(SceneState&)> apply_inputs; ///< called before the first picture
    std::optional<std::uint64_t> frames;           ///< how many; nothing: until a signal comes
};

/// The result of showing it.
struct ShownFrames {
    std::uint64_t shown = 0;
    std::uint64_t left_out = 0; ///< because the display, or this computer, was too slow
};

/// Shows it until its end, or until a signal arrives that RememberedInterruption remembers. The display is
/// lit when the first picture has arrived, and left asleep and dark, also on failure, as far as possible.
/// Throws Failure of the bus and its lines.
ShownFrames show_on_spi(const PanelShow& show, SpiDevice& spi, PanelLines& lines);
ShownFrames show_on_parallel(const PanelShow& show, PanelLines& lines);

}
