#pragma once

#include "core/pose/scene_state.hpp"
#include "firmware/link/drawing_part.hpp"
#include "firmware/status.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::link {

/// The progress of the next drawing of an input, kept as its mark.
struct DrawingProgress {
    bool has_begun = false;
    std::uint8_t number = 0; ///< DrawingNumber::number
    std::uint16_t parts = 0; ///< the number of parts that have come

    static constexpr DrawingProgress of(std::uint32_t mark)
    {
        return {(mark & 1) != 0, static_cast<std::uint8_t>(mark >> 1 & 7),
                static_cast<std::uint16_t>(mark >> 4)};
    }
    constexpr std::uint32_t mark() const
    {
        return (has_begun ? 1U : 0U) | std::uint32_t{number} << 1 | std::uint32_t{parts} << 4;
    }
    constexpr bool awaits(const DrawingPart& part) const
    {
        return has_begun && number == part.which.number && static_cast<std::uint8_t>(parts) == part.part;
    }
};

/// Returns whether all of them found room.
inline bool add(InputDrawing& drawing, std::span<const InputPoint> points)
{
    for (const InputPoint point : points)
        if (point.x == pen_up.x)
            drawing.begin_stroke();
        else if (!drawing.add(point))
            return false;
    return true;
}

/// Adds a part of a drawing to `player`, which shows it when its last part has come. A part that is not the
/// next one of its drawing drops what has come, and the drawing that is shown stays: the last part of
/// what was dropped fails with drawing_broken. Fails with no_drawing and drawing_large, too. The input of
/// `part` is one of the scene.
inline Status deliver(SceneState& player, const DrawingPart& part)
{
    if (player.scene().input(part.which.input).type != InputType::drawing)
        return Status::no_drawing;
    InputDrawing drawing = player.drawing(part.which.input);
    DrawingProgress progress = DrawingProgress::of(drawing.mark());
    if (!progress.awaits(part)) {
        drawing.begin();
        if (part.part != 0)
            return part.count ? Status::drawing_broken : Status::ok;
        progress = {.has_begun = true, .number = part.which.number};
    }
    const std::size_t before = std::size_t{progress.parts} * Points::max;
    const bool is_whole = !part.count || (*part.count >= before && *part.count - before <= Drawing::max);
    const bool fits =
        is_whole && add(drawing, part.points.first(part.count ? *part.count - before : Points::max));
    if (!fits) {
        drawing.begin();
        return is_whole ? Status::drawing_large : Status::drawing_broken;
    }
    if (part.count) {
        player.show_next_drawing(part.which.input);
    } else {
        ++progress.parts;
        drawing.set_mark(progress.mark());
    }
    return Status::ok;
}

}
