#pragma once

#include "core/bytes/picture_cache.hpp"
#include "core/raster/outline/grid.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// A corner near the origin, in half the room.
struct ShortCorner {
    std::int16_t x = 0;
    std::int16_t y = 0;
};

constexpr bool is_short(Corner corner)
{
    constexpr std::uint32_t half = 1U << 15;
    return ((static_cast<std::uint32_t>(corner.x) + half) | (static_cast<std::uint32_t>(corner.y) + half)) <
           2 * half;
}

/// A rotation, maybe mirrored, a scaling by at most 17/16, and a shift. Corners are rounded to nearest,
/// halves to the right and down.
class CornerMap {
public:
    static constexpr int fraction_bits = 14;
    /// The limit of a shift, in the grid: with it, what is in reach of Corner stays so.
    static constexpr std::int32_t max_shift = 1 << 19;

    CornerMap() = default;
    /// Factors in Q14; shifts in 1/65536 px, at most max_shift.
    CornerMap(std::int32_t xx, std::int32_t xy, std::int32_t yx, std::int32_t yy, std::int32_t x0,
              std::int32_t y0)
        : xx_{xx},
          xy_{xy},
          yx_{yx},
          yy_{yy},
          x_rest_{rest_of(x0)},
          y_rest_{rest_of(y0)},
          x_{x0 >> unit_bits},
          y_{y0 >> unit_bits}
    {
    }

    [[gnu::always_inline]] Corner operator()(const ShortCorner& corner) const
    {
        return {((xx_ * corner.x + xy_ * corner.y + x_rest_) >> fraction_bits) + x_,
                ((yx_ * corner.x + yy_ * corner.y + y_rest_) >> fraction_bits) + y_};
    }
    Corner operator()(Corner corner) const
    {
        if (is_short(corner))
            return (*this)(
                ShortCorner{static_cast<std::int16_t>(corner.x), static_cast<std::int16_t>(corner.y)});
        const auto placed = [corner](std::int32_t p, std::int32_t q, std::int32_t rest) {
            const std::int64_t sum = std::int64_t{p} * corner.x + std::int64_t{q} * corner.y + rest;
            return static_cast<std::int32_t>(sum >> fraction_bits);
        };
        return {placed(xx_, xy_, x_rest_) + x_, placed(yx_, yy_, y_rest_) + y_};
    }

    void add_to(Fingerprint& fingerprint) const
    {
        fingerprint.add(xx_, xy_);
        fingerprint.add(yx_, yy_);
        fingerprint.add(x_, x_rest_);
        fingerprint.add(y_, y_rest_);
    }

private:
    static constexpr int unit_bits = 16 - grid_bits;

    /// The fraction of a shift in the grid, in Q14, and half a unit for rounding.
    static constexpr std::int32_t rest_of(std::int32_t shift)
    {
        return ((shift & ((1 << unit_bits) - 1)) << (fraction_bits - unit_bits)) + (1 << (fraction_bits - 1));
    }

    std::int32_t xx_ = 1 << fraction_bits;
    std::int32_t xy_ = 0;
    std::int32_t yx_ = 0;
    std::int32_t yy_ = 1 << fraction_bits;
    std::int32_t x_rest_ = rest_of(0);
    std::int32_t y_rest_ = rest_of(0);
    std::int32_t x_ = 0;
    std::int32_t y_ = 0;
};

/// What contours are made of: two that are equal have the same ones.
struct ContourName {
    std::uint32_t drawing = 0;
    std::int32_t half_width = -1; ///< of the pen, in 1/65536 px; negative for a fill
    std::uint8_t pen = 0;         ///< its cap and join
    std::uint8_t miter_limit = 0;
    std::int8_t scale_bits = 0;
    std::uint8_t coarseness = 0; ///< less than 255, which names of other sets in the cache have in its place

    friend constexpr bool operator==(const ContourName&, const ContourName&) = default;

    void add_to(Fingerprint& fingerprint) const
    {
        fingerprint.add(static_cast<std::int32_t>(drawing), half_width);
        fingerprint.add(pen << 8 | miter_limit, scale_bits << 8 | coarseness);
    }
};

/// A contour before it is placed.
struct KeptContour {
    std::span<const ShortCorner> corners;
    std::size_t room; ///< corners that it had before it was simplified: that many must find room
};

/// Contours of drawings that move as a whole, before they are placed, in a cache: sets of contours, each a
/// word of counts and its corners. What is out of the range of ShortCorner is not kept.
class ContourCache {
public:
    /// `cache` must outlive this.
    explicit ContourCache(PictureCache& cache) : cache_{&cache} {}

    /// If they are kept, calls visit(KeptContour) for each of them, and returns true.
    template <class Visit>
    bool each_contour(const ContourName& name, Visit visit)
    {
        const std::uint32_t* at = cache_->find(words_of(name));
        if (at == nullptr)
            return false;
        for (const std::uint32_t* const end = at + cache_->count(); at != end;) {
            const std::uint32_t counts = *at++;
            const std::size_t corners = counts & max_count;
            visit(KeptContour{{reinterpret_cast<const ShortCorner*>(at), corners}, counts >> count_bits});
            at += corners;
        }
        return true;
    }

    /// Keeps the contours that are added until end(). None of this name is kept yet.
    void begin(const ContourName& name)
    {
        is_one_far_ = false;
        cache_->begin(words_of(name), PictureCache::Incoming::beside_others);
    }
    /// Adds a contour that is simplified; `room` as in KeptContour.
    [[gnu::cold, gnu::noinline]] void add(std::span<const Corner> contour, std::size_t room);
    /// Ends the set. It is not kept if some contours are missing.
    void end(bool are_complete) { cache_->end(are_complete && !is_one_far_); }

private:
    static constexpr int count_bits = 16; ///< of corners; above it, of the room
    static constexpr std::size_t max_count = (1U << count_bits) - 1;

    static PictureCache::Name words_of(const ContourName& name)
    {
        return std::bit_cast<PictureCache::Name>(name);
    }

    PictureCache* cache_;
    bool is_one_far_ = false; ///< whether a contour that was added did not fit into its words
};

}
