#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/math/affine.hpp"
#include "core/math/point.hpp"
#include "core/pose/posed_bones.hpp"
#include "core/pose/posed_strokes.hpp"
#include "core/scene/input_view.hpp"
#include "core/scene/number_text.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

/// A glyph of a text and its position.
struct PlacedGlyph {
    std::uint32_t drawing = 0; ///< offset in the section of drawings
    Point origin;              ///< where the drawing's (0, 0) is, in whole 1/16 px
};

/// Lays out a text by the advances of its glyphs, one after the other. Where each of them begins is rounded
/// once, to the nearest 1/16 px, halves to the right.
class LabelLayout {
public:
    /// `label` must outlive it; `glyphs` are numbers of the label's glyphs.
    LabelLayout(const LabelView& label, std::span<const std::byte> glyphs);

    bool at_end() const { return rest_.empty(); }
    /// Only when not at the end.
    PlacedGlyph next();

private:
    std::int32_t step() const;

    const LabelView& label_;
    std::span<const std::byte> rest_;
    std::int32_t x_; ///< where the next glyph begins, in 1/4096 px
};

/// A text or a number as a label shows it.
class LabelTrace {
public:
    /// `glyphs` are those of the text, `drawings` is the scene's section of drawings; both must outlive it.
    LabelTrace(const LabelView& label, std::span<const std::byte> glyphs, std::span<const std::byte> drawings)
        : label_{label}, text_{glyphs}, drawings_{drawings}
    {
    }
    /// The number that `input` is at `place`; the label shows one.
    LabelTrace(const LabelView& label, const InputView& input, Time place,
               std::span<const std::byte> drawings)
        : label_{label}, number_{label.format, input, place}, drawings_{drawings}
    {
    }

    /// Where the first stroke begins; the origin if there is none.
    Point start() const;
    /// Adds the strokes of all glyphs, placed.
    template <class Outline>
    void trace(const Affine& placement, Outline& outline) const
    {
        for (LabelLayout layout{label_, glyphs()}; !layout.at_end();) {
            const PlacedGlyph glyph = layout.next();
            count_op(Op::object);
            DeformedDrawing drawing{PackedDrawing{drawings_, glyph.drawing, glyph.origin}};
            trace_strokes(drawing, placement, outline);
        }
    }

private:
    std::span<const std::byte> glyphs() const { return label_.shows_number ? number_.glyphs() : text_; }

    LabelView label_;
    std::span<const std::byte> text_{};
    NumberText number_;
    std::span<const std::byte> drawings_;
};

/// The texts that a scene takes from outside, as numbers of their glyphs, in memory that the caller lends.
class InputTexts {
public:
    /// Bytes of memory for all of them.
    static std::size_t bytes_for(const SceneView& scene);

    InputTexts() = default;
    /// `memory` has bytes_for(scene). Holds the default texts.
    InputTexts(const SceneView& scene, std::span<std::byte> memory);

    /// The glyphs of the input `number`, a text, of `scene`, the scene that these were made for.
    std::span<const std::byte> glyphs(const SceneView& scene, std::uint32_t number) const;
    /// Sets it to `text`, in UTF-8. Returns whether that changes it. Characters without a glyph are left out,
    /// and so are those beyond the maximum length. An input that is no text stays as it is.
    bool put(const SceneView& scene, std::uint32_t number, std::string_view text);

private:
    std::span<std::byte> memory_; ///< of each text the number of its glyphs, and room for the maximum
};

}
