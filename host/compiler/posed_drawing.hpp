#pragma once

#include "core/drawing_reader.hpp"
#include "host/compiler/skinned_drawing.hpp"
#include "host/scene/bone_frames.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast {

/// A drawing as bones carry it at one moment (docs/format.md, "Skins").
class PosedDrawing {
public:
    /// `motions` are those of all bones of the skeleton.
    PosedDrawing(const SkinnedDrawing& skinned, const std::vector<scene::BoneMotion>& motions);

    struct Stroke {
        Point start;
        std::vector<Segment> segments;
    };
    const std::vector<Stroke>& strokes() const { return strokes_; }

private:
    std::vector<Stroke> strokes_;
};

/// Lets the core's algorithms read a posed drawing, which must outlive the reader.
class PosedReader {
public:
    explicit PosedReader(const PosedDrawing& drawing) : drawing_{&drawing} {}

    std::uint32_t strokes() const { return static_cast<std::uint32_t>(drawing_->strokes().size()); }

    std::uint32_t next_stroke()
    {
        stroke_ = &drawing_->strokes()[next_stroke_++];
        next_segment_ = 0;
        return static_cast<std::uint32_t>(stroke_->segments.size());
    }

    Point start() const { return stroke_->start; }
    Segment next_segment() { return stroke_->segments[next_segment_++]; }

private:
    const PosedDrawing* drawing_;
    const PosedDrawing::Stroke* stroke_ = nullptr;
    std::size_t next_stroke_ = 0;
    std::size_t next_segment_ = 0;
};

static_assert(DrawingReader<PosedReader>);

}
