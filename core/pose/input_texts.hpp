#pragma once

#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

/// The texts that a scene takes from outside, as numbers of their glyphs, in memory that the caller lends.
class InputTexts {
public:
    /// Bytes of memory for all of them.
    static std::size_t bytes_for(const SceneView& scene);

    InputTexts() = default;
    /// `memory` has bytes_for(scene). Holds what is default.
    InputTexts(const SceneView& scene, std::span<std::byte> memory);

    /// The glyphs of the input `number` of `scene`, the one that these were made for; it is a text.
    std::span<const std::byte> glyphs(const SceneView& scene, std::uint32_t number) const;
    /// Makes it `text`, in UTF-8, and tells whether that changes it. Characters without a glyph are left out,
    /// and so are those beyond the most that the input takes. An input that is no text stays as it is.
    bool put(const SceneView& scene, std::uint32_t number, std::string_view text);

private:
    std::span<std::byte> memory_; ///< of each text how many glyphs it has, and room for the most of them
};

}
