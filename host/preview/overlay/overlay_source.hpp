#pragma once

#include "core/time/time.hpp"
#include "host/picture/frame_source.hpp"
#include "host/preview/controls/view_options.hpp"
#include "host/preview/overlay/overlay.hpp"
#include "host/preview/overlay/posed_scene.hpp"
#include "host/preview/playback/item_facts.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace kfast {

/// Makes what is drawn over the pictures of one scene. Its inputs must be set as those of the FrameSource
/// that makes the pictures.
class OverlaySource final : public InputReceiver {
public:
    /// `viewport.scene`'s bytes must outlive the source.
    explicit OverlaySource(const Viewport& viewport);
    ~OverlaySource() override;

    /// The overlay that `view` asks for, over the picture at a time of the timeline; of an item that is
    /// selected also its outline. Labels that would overlap are left out: in a window a pixel of the panel is
    /// `scale` pixels wide. Valid until the next call.
    ///
    /// Changed areas are what a board would send after the picture that was asked for before, at first after
    /// the one a frame earlier; they stay when the same time is asked for again.
    const Overlay& show(Time moment, const ViewOptions& view, double scale = 2);
    /// The topmost item that paints at a point of the panel, by its number in SceneFile::item_names; a leaf,
    /// for groups and uses paint nothing themselves. On a beam's screen, the one whose outline is nearest, if
    /// it is near.
    std::optional<std::size_t> item_at(Time moment, PanelSpot spot);

    /// The facts of an item at a time, by its number in SceneFile::item_names; none if it does not exist.
    ItemFacts facts(Time moment, std::size_t item);

    bool set(std::uint32_t number, const InputContent& content) override;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
    Overlay overlay_;
};

}
