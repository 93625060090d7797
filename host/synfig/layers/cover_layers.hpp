#pragma once

#include "host/synfig/reading/layer.hpp"

#include <optional>

namespace kfast::synfig {

/// Whether a layer fills all of the canvas: one colour, a gradient, or noise.
bool is_cover(const Layer& layer);

/// What a cover paints: a rectangle over everything, or a circle where a radial gradient fades out. Nothing
/// for layers of other types.
std::optional<art::Node> read_cover_layer(const Layer& layer);

/// The colour of a layer; of a gradient the mean.
Colour colour_at(const Layer& layer, double frame);
/// The parameter that colour_at() reads.
const char* colour_name(const Layer& layer);
/// All of the canvas with a margin of its size.
scene::Outline everywhere(const Reading& reading);

/// The content of a group that draws nothing but covers.
struct CoverGroup {
    Layer lowest;
    bool is_alone = true; ///< nothing else is drawn, or erases
};

/// Nothing for groups that draw other things, or nothing at all.
std::optional<CoverGroup> covers_in(const Layer& group);

}
