#pragma once

#include "core/bytes/expects.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/raster/cells.hpp"
#include "core/raster/outline/paint_step.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// Finds the steps of two pictures that represent the same thing, in the order of both, and notes each as the
/// partner of the other.
void match(std::span<PaintStep> shown, std::span<PaintStep> next);

/// A set of slots, a bit for each.
using SlotMask = std::uint32_t;

inline constexpr int slot_count = 32;

constexpr SlotMask bit_of(unsigned slot)
{
    expects(slot < slot_count);
    return SlotMask{1} << slot;
}

/// The lowest bit of a mask, which is the topmost layer; 0 of an empty mask.
constexpr SlotMask top_bit(SlotMask mask) { return mask & (0U - mask); }

/// A de Bruijn sequence and its positions.
inline constexpr std::uint32_t bit_sequence = 0x077C'B531;
inline constexpr std::array<std::uint8_t, 32> bit_numbers{0,  1,  28, 2,  29, 14, 24, 3,  30, 22, 20,
                                                          15, 25, 17, 4,  8,  31, 27, 13, 23, 21, 19,
                                                          16, 7,  26, 12, 18, 6,  11, 5,  10, 9};

/// The number of a bit. A Cortex-M0 has no instruction for it.
constexpr unsigned number_of(SlotMask bit)
{
    expects(bit != 0 && top_bit(bit) == bit);
#if defined(__ARM_ARCH_6M__)
    return bit_numbers[bit * bit_sequence >> 27];
#else
    return static_cast<unsigned>(__builtin_ctz(bit));
#endif
}

/// Layers of the next picture and of the one that the panel shows, in one order: slot 31 for the lowest of
/// a set of layers, and so on upwards. A layer that both have has one slot.
class Slots {
public:
    /// What is in one slot.
    struct Layer {
        const PaintStep* next = nullptr;
        const PaintStep* shown = nullptr;
        std::uint32_t ink = 0;   ///< of the next picture, see cells.hpp
        std::uint32_t share = 0; ///< of its opacity, in the next picture, see cells.hpp
    };

    Colour background; ///< opaque
    std::uint32_t background_ink = 0;

    /// Sets the steps of both pictures, whose partners have been found.
    [[gnu::cold, gnu::noinline]] void set_pictures(std::span<PaintStep> next, std::span<PaintStep> shown);
    /// Whether a layer of the next picture has the same outlines as its partner, and looks the same.
    bool is_same(const PaintStep& next) const
    {
        return next.partner != PaintStep::no_partner && has_same_outlines(next, shown_[next.partner]) &&
               is_same_colour(next, shown_[next.partner]);
    }
    /// Whether all layers have slots of their own; if not, assign() gives slots to the layers of a band.
    bool hold_all() const { return hold_all_; }
    void clear_marks();
    static void mark(PaintStep& layer) { layer.slot = 0; }
    /// Gives slots to the layers that are marked. Returns false if there are too many: some have a wrong one.
    [[gnu::cold, gnu::noinline]] bool assign();

    template <class Cells>
    void set_inks()
    {
        background_ink = Cells::ink(background);
        for (unsigned slot = free_; slot != slot_count; ++slot)
            if (Layer& layer = layers_[slot]; layer.next != nullptr) {
                layer.ink = Cells::ink(layer.next->colour);
                layer.share = opacity_share<Cells>(layer.next->colour.opacity);
            }
    }

    const Layer& layer(unsigned slot) const { return layers_[slot]; }
    /// Whether a pixel that the layers `next` cover wholly looks as the layers `shown` made it look.
    bool looks_same(SlotMask next, SlotMask shown) const;
    /// Whether one opaque layer is above all of `touched`, in both pictures; the masks are of the layers
    /// that cover a position wholly, except for `touched`.
    bool is_hidden(SlotMask next, SlotMask shown, SlotMask touched) const;

    SlotMask same = 0;       ///< outlines and rule are those of the shown picture
    SlotMask recoloured = 0; ///< colour or opacity, or that of a group around it, has changed
    SlotMask clear = 0;      ///< of the next picture: not opaque, or within a group
    SlotMask shown_clear = 0;
    SlotMask grouped = 0;  ///< of the next picture, within a group
    SlotMask even_odd = 0; ///< of the next picture

private:
    static bool has_same_outlines(const PaintStep& next, const PaintStep& shown)
    {
        return next.outlines == shown.outlines && next.rule == shown.rule;
    }
    bool is_same_colour(const PaintStep& next, const PaintStep& shown) const;
    bool put(PaintStep* next, PaintStep* shown);

    std::array<Layer, slot_count> layers_;
    std::span<PaintStep> next_;
    std::span<PaintStep> shown_;
    unsigned free_ = slot_count;
    bool has_same_groups_ = false;
    bool hold_all_ = true;
};

}
