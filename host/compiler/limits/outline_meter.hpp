#pragma once

#include "core/pose/posed_backbones.hpp"
#include "core/pose/posed_bones.hpp"
#include "core/raster/outline/picture.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "core/tracer.hpp"
#include "host/compiler/limits/live_outlines.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace kfast {

/// Traces the pictures of a scene on a panel that is as wide as its canvas and three times as high, as far as
/// panels go: one of another shape shows more than the canvas.
class OutlineMeter {
public:
    /// `bytes` for the outlines of a picture, a multiple of 4; `scene` must outlive it.
    OutlineMeter(const SceneView& scene, std::size_t bytes);

    /// From the next picture on, the input `number` is `text` (Player::set_text).
    void put_text(std::uint32_t number, std::string_view text);
    /// With nothing in the drawings from outside. Valid until the next call.
    const raster::Picture& picture_at(const SceneTime& moment);
    /// What these add at the same moment at most, whatever comes.
    std::size_t live_bytes() const;

private:
    void trace();

    std::vector<std::uint32_t> outlines_; // words, for the store asks for an alignment of 4
    std::vector<std::uint32_t> cache_;    // likewise
    std::vector<std::uint32_t> heads_;
    std::vector<raster::PaintStep> steps_;
    std::vector<std::uint32_t> prepared_; // likewise
    std::vector<Space> spaces_;
    std::vector<PosedBone> bones_;
    std::vector<BackboneNode> backbone_nodes_;
    std::vector<std::uint32_t> drawings_; // words, likewise
    std::vector<std::byte> texts_;
    std::uint32_t changed_inputs_ = 0; ///< a bit for each input whose text is another than in the picture
    SceneOnPanel on_panel_;
    raster::Picture picture_;
};

}
