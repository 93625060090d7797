#pragma once

#include "core/bytes/picture_cache.hpp"
#include "core/raster/outline/corner_map.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

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
    std::size_t room; ///< corners that it had before it was simplified: so many must find room
};

/// Contours of drawings that move as a whole, before they are placed, in a cache: sets of contours, each a
/// word of counts and its corners. What lies further away than ShortCorner tells is not kept.
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

    /// Keeps those that come until end(). None of this name is kept.
    void begin(const ContourName& name)
    {
        is_one_far_ = false;
        cache_->begin(words_of(name), PictureCache::Coming::beside_others);
    }
    /// A contour that is simplified; `room` as in KeptContour.
    [[gnu::cold, gnu::noinline]] void add(std::span<const Corner> contour, std::size_t room);
    /// They are not kept if some are missing.
    void end(bool are_complete) { cache_->end(are_complete && !is_one_far_); }

private:
    static constexpr int count_bits = 16; ///< of corners; above it, of the room
    static constexpr std::size_t max_count = (1U << count_bits) - 1;

    static PictureCache::Name words_of(const ContourName& name)
    {
        return std::bit_cast<PictureCache::Name>(name);
    }

    PictureCache* cache_;
    bool is_one_far_ = false; ///< a contour that was added has not found place in its words
};

}
