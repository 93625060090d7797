#pragma once

#include "core/pose/input_drawing.hpp"
#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// The drawings that a scene takes from outside, in memory that the caller lends.
class InputDrawings {
public:
    /// Bytes of memory for all of them; a multiple of 4.
    static std::size_t bytes_for(const SceneView& scene);

    InputDrawings() = default;
    /// `memory`, aligned to 4 bytes, has bytes_for(scene). Shows what is default.
    InputDrawings(const SceneView& scene, std::span<std::byte> memory);

    /// Shows all of them as they are before anything has come: part of making them, for the feature.
    void show_default(const SceneView& scene) const;

    /// That of the input `number` of `scene`, the one that these were made for; it is a drawing.
    InputDrawing of(const SceneView& scene, std::uint32_t number) const;

private:
    std::span<std::byte> memory_;
};

}
