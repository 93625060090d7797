#pragma once

#include "host/lottie/layers/composition.hpp"

#include <optional>
#include <string>

namespace kfast::lottie {

enum class LayerKind : int {
    precomposition = 0,
    solid = 1,
    image = 2,
    null = 3,
    shapes = 4,
    text = 5,
    audio = 6,
    video = 9,
    guide = 11,
    adjustment = 12,
    camera = 13,
    light = 14,
};

LayerKind kind_of(const Json& layer);

/// The name as in the file; empty if it has none, or one that is no text.
std::string given_name(const Json& layer);
/// The name as in the file, or "layer 3" by its number.
std::string name_of(const Json& layer, std::size_t index);

/// When it is visible, in frames of the scene; unbounded at both ends if that is all of `seen`.
art::Span span_of(const Json& layer, const LayerTime& time, const art::Span& seen);

/// A layer while it is imported into the scene.
struct Layer {
    const Json& json;
    const Reading& reading;
    const Around& around; ///< its own transform and those outside of it
    art::Span seen;       ///< from and to a frame
};

/// What it draws in its own coordinates, before masks; reports what it cannot draw.
std::vector<art::Node> read_content(const Layer& layer, Animation& animation);

/// The drawing of a solid, in its own coordinates.
art::Drawing solid_drawing(const Json& solid);
/// Its colour. Nothing if "sc" is no colour such as "#ff8000".
std::optional<art::Rgb> solid_colour(const Json& solid);

/// Applies the masks of a layer to what it draws: those that show or hide all of it, and those that cut a
/// solid to their own shape. Others are reported.
void apply_masks(std::vector<art::Node>& nodes, const Layer& layer);

/// What the composition of a layer draws, with the layer's start, stretch and time remapping. Throws
/// WrongMember when there is none, or it uses itself.
std::vector<art::Node> read_precomposition(const Layer& layer, Animation& animation);

/// The layer whose picture another one is matted by.
struct MatteSource {
    const Layer& layer;
    std::vector<art::Node> nodes; ///< what it draws, in its own coordinates
    art::Span shown;
};

/// Applies a matte ("tt") to what a layer draws, if it shows or hides all of it. Others are reported.
void apply_matte(std::vector<art::Node>& nodes, const Layer& layer, MatteSource source);

/// Reports that a matte is not applied.
void report_matte(const Layer& layer);

}
