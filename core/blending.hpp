#pragma once

#include "core/scene_view.hpp"

#include <cstdint>

namespace kfast {

/// Fills and strokes of an object or a live item.
constexpr std::uint32_t layer_count(const ObjectStyle& style)
{
    return (style.is_filled ? 1U : 0U) + (style.is_stroked ? 1U : 0U);
}

/// Whether the opacity of `item` has to apply to its finished picture: a single layer is made transparent by
/// its colour, in however many groups and symbols it lies alone.
bool has_several_layers(const SceneView& scene, const ItemView& item);

/// Whether the picture of `item` is blended as a whole at some moment.
bool may_be_blended(const SceneView& scene, const ItemView& item);

}
