#include "core/raster/outline/trimmed_outline.hpp"

namespace kfast {
namespace {

/// Adds pieces to an outline that passes strokes to a trimmer.
struct OutlinePieces {
    ObjectOutline& outline;

    [[gnu::cold]] void begin(Point at) { outline.begin_piece(at); }
    [[gnu::cold]] void add(const Segment& segment) { outline.add_to_piece(segment); }
    [[gnu::cold]] void end_piece(Point hub, PieceEnd end) { outline.end_piece(hub, end); }
    int pieces_of(const Segment& segment) const { return outline.pieces_of(segment); }
};

}

/// Here, for it is linked only with what trims.
void ObjectOutline::end_piece(Point hub, PieceEnd end)
{
    if (!stroke_ || end == PieceEnd::open || end == PieceEnd::closed)
        return end_whole(hub, end == PieceEnd::closed);
    if (end == PieceEnd::at_seam)
        return stroke_->end_at_seam();
    stroke_->end_after_seam();
}

void trace_trimmed(const Trim& trim, const Affine& placement, ObjectOutline& outline,
                   FunctionRef<void(const Affine&, ObjectOutline&)> trace)
{
    OutlinePieces pieces{outline};
    StrokeTrimmer trimmer{trim, placement, PieceSink::of(pieces)};
    outline.trim_with(&trimmer);
    trimmer.run([&](StrokeTrimmer&) { trace(Affine{}, outline); });
    outline.trim_with(nullptr);
}

}
