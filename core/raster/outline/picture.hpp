#pragma once

#include "core/bytes/picture_cache.hpp"
#include "core/raster/outline/outline_store.hpp"
#include "core/raster/outline/paint_step.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// The picture of a scene at a time, ready to be drawn, in memory that the caller lends.
struct Picture {
    OutlineStore outlines;
    PictureCache cache;           ///< of contours before they are placed, and of key drawings made equal
    std::span<PaintStep> storage; ///< of the steps
    std::size_t step_count = 0;
    Dependence dependence;       ///< what it depends on: the same as long as nothing of that moves
    std::uint8_t coarseness = 0; ///< how often the length of pieces of curves was doubled to find room

    /// Whether, for want of room, its curves are coarser, or parts of it are missing.
    bool is_coarse() const { return coarseness != 0 || outlines.is_full(); }

    /// There is room for all steps that a scene needs. If two items had the same path and one were taken for
    /// the other, the last step would be lost, but no memory.
    PaintStep& add_step(const PaintStep& step)
    {
        if (step_count < storage.size())
            ++step_count;
        return storage[step_count - 1] = step;
    }

    /// Adds a layer, which is named by its step and `part`: with the outlines that are kept for it, or with
    /// those that trace() adds to `outlines`, which depend on `layer_dependence`.
    template <class Trace>
    void add_layer(const PaintStep& step, std::uint8_t part, const Dependence& layer_dependence, Trace trace)
    {
        PaintStep& added = add_step(step);
        const auto number = static_cast<std::uint16_t>(step_count - 1);
        const LayerName name{step.item, part};
        const LayerOutlines* layer = outlines.reuse(name, number);
        if (layer == nullptr) {
            outlines.begin_layer(name, number);
            trace();
            layer = outlines.end_layer(layer_dependence);
        }
        if (layer == nullptr)
            return; // it found no room
        added.outlines = layer->fingerprint;
        added.rows = layer->rows;
    }

    std::span<PaintStep> steps() { return storage.first(step_count); }
    std::span<const PaintStep> steps() const { return storage.first(step_count); }
};

}
