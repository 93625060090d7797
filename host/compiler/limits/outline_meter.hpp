#pragma once

#include "core/pose/posed_backbones.hpp"
#include "core/pose/posed_bones.hpp"
#include "core/raster/outline/picture.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "core/tracer.hpp"
#include "host/compiler/limits/measured_moments.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// Bytes that the outlines of all visible live drawings take in an OutlineStore at the time to which the
/// scene was moved, whatever is received: those of the worst drawings that were tried
/// (tests/host/compiler/live_outlines_test.cpp).
std::size_t live_outline_bytes(const SceneOnPanel& on_panel);

/// Traces the pictures of a scene on a panel that is as wide as its canvas and three times as high, as far as
/// panels go: one of another shape shows more than the canvas.
class OutlineMeter {
public:
    /// `bytes` for the outlines of a picture, a multiple of 4; `scene` must outlive it.
    OutlineMeter(const SceneView& scene, std::size_t bytes);

    /// From the next picture on, the input `number` is `text` (Player::set_text).
    void put_text(std::uint32_t number, std::string_view text);
    /// The picture with nothing in the drawings from outside. Valid until the next call.
    const raster::Picture& picture_at(const SceneTime& moment);
    /// What these add at the same time at most, whatever is received.
    std::size_t live_bytes() const;

private:
    void trace();

    std::vector<std::uint32_t> outlines_; // words, for the store asks for an alignment of 4
    std::vector<std::uint32_t> cache_;    // words as well
    std::vector<std::uint32_t> heads_;
    std::vector<raster::PaintStep> steps_;
    std::vector<std::uint32_t> prepared_; // words as well
    std::vector<Space> spaces_;
    std::vector<PosedBone> bones_;
    std::vector<BackboneNode> backbone_nodes_;
    std::vector<std::uint32_t> drawings_; // words, also for the alignment
    std::vector<std::byte> texts_;
    std::vector<Time> inputs_;         ///< the place of each, as in the picture
    std::uint32_t changed_inputs_ = 0; ///< a bit for each input whose value differs from that in the picture
    SceneOnPanel on_panel_;
    raster::Picture picture_;
};

/// The most that the outlines need at eight of `moments`, or fewer, of which there is at least one.
std::size_t peak_bytes(std::span<const MeasuredMoment> moments, OutlineMeter& meter);

/// A text for each input of a scene; empty where the input is none.
using LargestTexts = std::vector<std::string>;

void put_texts(const LargestTexts& texts, OutlineMeter& meter);

/// Texts with which the outlines of a scene are largest: each is as many of one character as the input may
/// have. Searched at some of `moments`, of which there is at least one; several of them if different
/// characters are the largest at different times. `meter` is one of the scene; its texts are changed
/// afterwards.
std::vector<LargestTexts> largest_texts(const SceneView& scene, std::span<const MeasuredMoment> moments,
                                        OutlineMeter& meter);

}
