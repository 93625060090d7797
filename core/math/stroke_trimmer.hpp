#pragma once

#include "core/bytes/function_ref.hpp"
#include "core/math/affine.hpp"
#include "core/math/dashes.hpp"
#include "core/math/flatten.hpp"
#include "core/math/point.hpp"

#include <array>
#include <cstdint>

namespace kfast {

/// What the shares of a Trim are shares of.
enum class TrimMode : std::uint8_t {
    each,     ///< the length of each stroke
    together, ///< the length of all strokes, one after the other
    sector,   ///< the curves of each stroke, which is a pie: lines from its centre lead to what is left
};

/// How much of the length of strokes is drawn: from `begin` on, and past the end again from the beginning.
/// What is left is dashed, its pattern beginning where it does.
struct Trim {
    static constexpr std::uint32_t whole = 1U << 24; ///< all of the length

    std::uint32_t begin = 0; ///< 0 … whole - 1
    std::uint32_t share = whole;
    TrimMode mode = TrimMode::each; ///< of what is dashed, not sector
    Dashes dashes = {};

    /// From one share to the other, both clamped to 0 … whole and exchanged if they do not rise, moved by
    /// `offset`, which is taken modulo `whole`.
    static Trim between(std::int32_t from, std::int32_t to, std::int32_t offset, TrimMode mode);

    /// The same for a fill, which is not dashed.
    Trim of_fill() const { return {.begin = begin, .share = share, .mode = mode}; }
    bool is_whole() const { return share == whole && dashes.count == 0; }
    bool is_empty() const { return share == 0; }
};

/// How a piece of a stroke ends. Of a closed stroke that is drawn across its seam, the piece behind the seam
/// comes first, and the one before it last:
///
///      first piece               last piece
///     seam --------> ...  ... ---------> seam
///     after_seam                 at_seam
enum class PieceEnd : std::uint8_t {
    open,       ///< both of its ends are ends of the line
    closed,     ///< it is a whole stroke, which closes
    after_seam, ///< it began at the seam, where the last piece will be joined to it
    at_seam,    ///< it ends where the first piece began
};

/// What takes the pieces of trimmed strokes, placed.
class PieceSink {
public:
    /// `target`, which must outlive it, has
    ///
    ///     begin(Point), add(const Segment&)   as of an outline (PosedStrokes::trace())
    ///     end_piece(Point hub, PieceEnd)      a fill is closed by way of `hub`: of a piece at the seam, that
    ///                                         is where the first piece ended
    ///     pieces_of(const Segment&)           how many straight pieces replace a placed segment
    template <class Target>
    static PieceSink of(Target& target)
    {
        PieceSink sink;
        sink.target_ = &target;
        sink.begin_ = [](void* to, Point at) { static_cast<Target*>(to)->begin(at); };
        sink.add_ = [](void* to, const Segment& segment) { static_cast<Target*>(to)->add(segment); };
        sink.end_ = [](void* to, Point hub, PieceEnd end) { static_cast<Target*>(to)->end_piece(hub, end); };
        sink.pieces_of_ = [](void* to, const Segment& segment) {
            return static_cast<Target*>(to)->pieces_of(segment);
        };
        return sink;
    }

    void begin(Point at) const { begin_(target_, at); }
    void add(const Segment& segment) const { add_(target_, segment); }
    void end(Point hub, PieceEnd end) const { end_(target_, hub, end); }
    int pieces_of(const Segment& segment) const { return pieces_of_(target_, segment); }

private:
    PieceSink() = default;

    void* target_ = nullptr;
    void (*begin_)(void*, Point) = nullptr;
    void (*add_)(void*, const Segment&) = nullptr;
    void (*end_)(void*, Point, PieceEnd) = nullptr;
    int (*pieces_of_)(void*, const Segment&) = nullptr;
};

/// Cuts the strokes of one object where a trim and its dashes say, by their length in the object's own space.
/// It takes them as an outline does (PosedStrokes::trace()), several times: the length of a stroke must be
/// known before its first piece.
///
///     measure all    for TrimMode::together: the length of all strokes
///     measure        the lengths of the next 16 strokes       \  again and again, until
///     cut            the same strokes, in pieces to the sink  /  there is no stroke left
///
/// Its code is cold: a board leaves it in flash. Few scenes trim, and where one does, what it traces again
/// takes longer.
///
/// Lengths are those of the chords of curves, in 1/4096 px; a cut is within 1/16 px of where it would be
/// along the curve. What is longer than 2^20 px in all counts as if it was as long.
class StrokeTrimmer {
public:
    static constexpr std::uint32_t batch = 16; ///< the strokes whose lengths are measured before they are cut

    /// `placement` maps the strokes to what the sink takes. `trim` and `placement` must outlive it.
    StrokeTrimmer(const Trim& trim, const Affine& placement, PieceSink sink);

    /// trace(trimmer) passes the strokes, unplaced, to the trimmer; the same ones each time.
    [[gnu::cold]] void run(FunctionRef<void(StrokeTrimmer&)> trace);

    // As of an outline, called by what traces strokes.

    void begin(Point at) { code_->begin(*this, at); }
    void add(const Segment& segment) { code_->add(*this, segment); }
    void end(Point hub, bool is_closed) { code_->end(*this, hub, is_closed); }

private:
    /// The functions that work on it: linked only with what makes one.
    struct Code {
        void (*begin)(StrokeTrimmer&, Point at);
        void (*add)(StrokeTrimmer&, const Segment&);
        void (*end)(StrokeTrimmer&, Point hub, bool is_closed);
    };
    static const Code code;

    /// Of the chords of a segment, the next one, and where on the segment the current piece begins.
    struct ChordPlace {
        std::uint32_t chords = 0;
        std::uint32_t number = 0;
        Fraction begin = {};
    };

    enum class Pass : std::uint8_t { measure_all, measure, cut };

    /// From one length along a stroke to another.
    struct Window {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
    };

    struct Measured {
        std::uint32_t length = 0; ///< in 1/4096 px
        bool is_closed = false;   ///< in a sector: whether its curves end where they began
    };

    [[gnu::cold, gnu::noinline]] void begin_stroke(Point at);
    [[gnu::cold, gnu::noinline]] void take(const Segment& segment);
    [[gnu::cold, gnu::noinline]] void end_stroke(Point hub, bool is_closed);

    bool is_in_batch() const { return stroke_ - first_ < batch; }
    Measured& measured() { return measured_[stroke_ - first_]; }
    bool has_no_length(const Segment& segment) const;
    [[gnu::cold]] void set_windows();
    [[gnu::cold]] void add_window(std::uint64_t begin, std::uint64_t end);
    [[gnu::cold]] void begin_window();
    [[gnu::cold]] void look_at_ends(bool reaches_both_ends);
    [[gnu::cold]] void next_part();
    [[gnu::cold]] bool next_dash(const Window& window);
    [[gnu::cold]] void each_chord(const Segment& segment, FunctionRef<void(std::uint32_t length)> take) const;
    std::uint32_t length_of(const Segment& segment) const;
    int pieces_of(const Segment& segment) const;
    [[gnu::cold]] Segment placed(const Segment& segment) const;
    [[gnu::cold]] void cut(const Segment& segment);
    [[gnu::cold, gnu::noinline]] void cut_chord(const Segment& segment, std::uint32_t chord,
                                                ChordPlace& place);
    [[gnu::cold]] void begin_piece(Point at);
    [[gnu::cold]] void add(const Segment& segment, Fraction begin, Fraction end);
    [[gnu::cold]] void line_to(Point to);
    [[gnu::cold]] void end_piece();

    const Code* code_ = &code;
    const Trim& trim_;
    PointMap place_;
    PieceSink sink_;
    Pass pass_ = Pass::measure;
    std::uint32_t stroke_ = 0; ///< the current one
    std::uint32_t first_ = 0;  ///< of the current batch
    std::uint32_t total_ = 0;  ///< the length of all strokes
    std::uint32_t before_ = 0; ///< the length of all strokes before the current one
    std::uint32_t dashes_ = 0; ///< so far
    std::array<Measured, batch> measured_{};

    // Of the current stroke, while it is cut.
    std::array<Window, 2> windows_{};
    std::array<std::uint32_t, 2> pattern_begins_{}; ///< how far before each window the pattern did
    std::uint32_t window_count_ = 0;
    std::uint32_t window_ = 0;   ///< the current one
    Window part_;                ///< what is drawn now or next: a window, or a dash of it
    std::uint32_t position_ = 0; ///< the length of what has been read
    bool is_whole_ = false;      ///< it is passed on as it is
    bool crosses_seam_ = false;
    bool has_part_ = false;
    bool is_drawing_ = false; ///< within a part
    bool is_dashed_ = false;
    Dashes::Place dash_; ///< behind the part
    std::uint32_t dash_begin_ = 0;
    Point start_;       ///< of the stroke: the centre of a sector
    Point curve_start_; ///< of a sector
    Point curve_end_;
    Point piece_start_; ///< placed, as the next two
    Point last_;
    Point first_piece_end_;
};

}
