#pragma once

#include "core/pose/posed_bones.hpp"
#include "core/scene/drawing_view.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/scene/skin_reader.hpp"

#include <cstdint>
#include <span>

namespace kfast {

/// A key drawing as bones carry it at one moment, or, without a skin, as it was drawn.
///
/// A point moves as it would at rest, and keeps its distance from there: p + (bones(r) - r). Control points
/// go with the vertex that they belong to. Held within ±4095 px, so that drawings can be tweened.
class DeformedDrawing {
public:
    explicit DeformedDrawing(const PackedDrawing& drawing) : drawing_{drawing}, at_rest_{drawing} {}
    /// `bones` are those of the skin's skeleton, posed; they must outlive this. `at_rest` is the skin's, or
    /// `drawing` again.
    DeformedDrawing(const PackedDrawing& drawing, const PackedDrawing& at_rest, const SkinReader& skin,
                    std::span<const PosedBone> bones);

    std::uint32_t strokes() const { return drawing_.strokes(); }
    std::uint32_t next_stroke();
    Point start() const { return start_; }
    Segment next_segment();

private:
    /// What works on it where bones carry it: linked only with what makes such a one.
    struct Code {
        void (*begin_stroke)(DeformedDrawing&);
        void (*deform)(DeformedDrawing&, Segment& segment);
    };
    static const Code code;

    bool is_deformed() const { return code_ != nullptr; }
    void begin_deformed_stroke();
    void deform(Segment& segment);
    Point deformed(Point point, Point at_rest, const Binding& binding) const;

    const Code* code_ = nullptr;
    PackedDrawing drawing_;
    PackedDrawing at_rest_; ///< read in step with the other if there is one
    SkinReader skin_;
    std::span<const PosedBone> bones_;
    Point start_;
    Point at_; ///< the vertex read last as it is carried
};

static_assert(DrawingReader<DeformedDrawing>);

}
