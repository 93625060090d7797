#pragma once

#include "core/raster/corner_map.hpp"

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
    std::uint8_t coarseness = 0;

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

/// Contours of drawings that move as a whole, before they are placed: kept from picture to picture, in memory
/// that the caller lends. What finds no room, or what lies further away than ShortCorner tells, is not kept:
/// to make it anew gives the same corners.
///
///     | set | contour: counts, corners | contour | ... | set | contour | ...  free |
class ContourCache {
public:
    ContourCache() = default;
    /// `memory` is aligned to 4 bytes.
    explicit ContourCache(std::span<std::byte> memory) : memory_{memory.data()}, end_{memory.size() / 4 * 4}
    {
    }

    /// Contours that were of use in the picture before stay; others, if room is needed.
    void begin_picture();

    /// If they are kept, calls visit(KeptContour) for each of them, and returns true.
    template <class Visit>
    bool each_contour(const ContourName& name, Visit visit)
    {
        Set* const set = find(name);
        if (set == nullptr)
            return false;
        set->picture = picture_;
        const std::byte* at = reinterpret_cast<const std::byte*>(set + 1);
        for (const std::byte* const end = at + set->bytes - sizeof(Set); at != end;) {
            const auto& counts = *reinterpret_cast<const Counts*>(at);
            at += sizeof(Counts);
            visit(KeptContour{{reinterpret_cast<const ShortCorner*>(at), counts.corners}, counts.room});
            at += counts.corners * sizeof(ShortCorner);
        }
        return true;
    }

    /// Keeps those that come until end(). None of this name is kept.
    [[gnu::cold, gnu::noinline]] void begin(const ContourName& name);
    /// A contour that is simplified; `room` as in KeptContour.
    [[gnu::cold, gnu::noinline]] void add(std::span<const Corner> contour, std::size_t room);
    /// They are not kept if some are missing.
    [[gnu::cold, gnu::noinline]] void end(bool are_complete);

    /// What is taken by contours that were of use in this picture.
    std::size_t bytes_in_use() const;

private:
    struct Set {
        ContourName name;
        std::uint32_t bytes : 24;  ///< with its contours
        std::uint32_t picture : 8; ///< the last one that it was of use in
    };

    struct Counts {
        std::uint16_t corners;
        std::uint16_t room; ///< as in KeptContour
    };

    Set* find(const ContourName& name) const;
    Set& set_at(std::size_t place) const { return *reinterpret_cast<Set*>(memory_ + place); }
    bool find_room(std::size_t bytes);
    [[gnu::cold, gnu::noinline]] void remove_unused();

    std::byte* memory_ = nullptr;
    std::size_t end_ = 0;      ///< of the memory
    std::size_t used_ = 0;     ///< of it
    std::size_t coming_ = 0;   ///< place of the set that is coming in
    bool is_coming_ = false;   ///< one is, and has found room so far
    bool was_full_ = false;    ///< something found no room
    std::uint8_t picture_ = 0; ///< a number of it
};

}
