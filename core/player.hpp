#pragma once

#include "core/pixel_format.hpp"
#include "core/result.hpp"
#include "core/scene_view.hpp"
#include "core/size.hpp"
#include "core/time.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// How the canvas is laid on a panel of another size; always centred.
enum class Fit : std::uint8_t {
    contain, ///< as large as fits whole, background around it
    cover,   ///< as small as fills the panel, the rest is cut off
    none,    ///< one canvas pixel is one panel pixel
};

/// Draws any moment of a scene, rows from the top down, in memory that the caller lends.
class Player {
public:
    /// Bytes that create() must be lent, for every time of the scene.
    static std::size_t block_bytes(const SceneView& scene, Size panel);

    /// `scene`'s bytes and `block` (aligned to 4) must outlive the player. Fails with block_too_small.
    static Result<Player> create(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block);

    /// Computes the picture at `time` (wrapped by the scene's loop mode; any value is allowed).
    void show(Time time);

    /// Draws the next `rows` rows of the picture into `pixels` (rows x row_bytes(format, panel width) bytes).
    /// The first call after show() starts at row 0.
    template <PixelFormat format>
    void draw_rows(int rows, std::span<std::byte> pixels);
};

}
