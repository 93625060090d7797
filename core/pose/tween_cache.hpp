#pragma once

#include "core/bytes/picture_cache.hpp"
#include "core/pose/equalize.hpp"
#include "core/time/track.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast {

/// Reads two key drawings that have been made equal (core/pose/equalize.hpp) from the words of a cache, and
/// interpolates them. It reads what EqualizedPair would, in the same order and with the same bits: for each
/// stroke next_stroke(); next_point(), the first one; for each segment is_next_cubic(), and next_point() for
/// its end, or for both control points before it.
///
///     | strokes, form | stroke: segments, flags | hub | first point | kinds of 32 segments | points | ...
///
/// A point is a word of two 16-bit coordinates in 1/64 px, or two words of 32 bits in 1/65536 px, each for
/// either drawing, or once if there is only one.
class TweenReader {
public:
    explicit TweenReader(const std::uint32_t* words) : form_{words[0]}, at_{words + 1} {}

    std::uint32_t strokes() const { return form_ & max_strokes; }
    /// Whether a drawing is kept beside itself, or one beside another of the same form: then what is read at
    /// progress 0 is the first drawing itself.
    bool is_plain() const { return (form_ & plain_form) != 0; }

    /// Begins the next stroke, of strokes(), and returns the number of its segments.
    std::uint32_t next_stroke()
    {
        flags_ = *at_++;
        read_ = 0;
        hub_ = nullptr;
        if (!is_whole()) {
            hub_ = at_;
            at_ += words_of_point();
        }
        return flags_ & max_segments;
    }

    bool is_whole() const { return (flags_ & part_flag) == 0; }
    bool is_closed() const { return (flags_ & closed_flag) != 0; }

    bool is_next_cubic()
    {
        if (read_ % kinds_in_word == 0)
            kinds_ = *at_++;
        return (kinds_ >> (read_++ % kinds_in_word) & 1) != 0;
    }

    /// The next point, interpolated between both drawings.
    Point next_point(ProgressXY progress)
    {
        return is_short() ? next_short_point(progress) : wide_point(progress);
    }
    /// Whether points are short: within 512 px, and within 1024 px when interpolated.
    bool is_short() const { return (form_ & wide_form) == 0; }
    /// next_point(), only if points are short.
    Point next_short_point(ProgressXY progress)
    {
        const std::uint32_t from = *at_++;
        const std::uint32_t to = (form_ & single_form) != 0 ? from : *at_++;
        return {short_lerp(low(from), low(to), progress.x), short_lerp(high(from), high(to), progress.y)};
    }
    /// The next point in both drawings.
    Pair<Point> next_points()
    {
        const Pair<Point> both{point_at(at_), point_at(at_ + words_of_point() - words_of_one())};
        at_ += words_of_point();
        return both;
    }
    /// Only of a stroke that is not whole: EqualizedPair::hub().
    Pair<Point> hub() const { return {point_at(hub_), point_at(hub_ + words_of_point() - words_of_one())}; }

private:
    friend class TweenWriter;

    static constexpr std::uint32_t max_strokes = 0xFFFF;
    static constexpr std::uint32_t wide_form = 1 << 16;
    static constexpr std::uint32_t single_form = 1 << 17;
    static constexpr std::uint32_t plain_form = 1 << 18;
    static constexpr std::uint32_t max_segments = 0xFFFF;
    static constexpr std::uint32_t part_flag = 1 << 16;
    static constexpr std::uint32_t closed_flag = 1 << 17;
    static constexpr std::uint32_t kinds_in_word = 32;
    static constexpr int short_bits = 6; ///< short coordinates are in 1/64 px
    /// So that the product of the difference of two short ones with any progress fits in 32 bits.
    static constexpr std::int32_t max_short_difference = 13000;

    static std::int32_t low(std::uint32_t word) { return static_cast<std::int16_t>(word); }
    static std::int32_t high(std::uint32_t word) { return static_cast<std::int32_t>(word) >> 16; }

    /// Like lerp() of Fixed.
    static Fixed short_lerp(std::int32_t from, std::int32_t to, Progress progress)
    {
        return Fixed::from_raw(from * (Fixed::one >> short_bits) +
                               rounded_shift((to - from) * progress.raw, short_bits));
    }

    std::uint32_t words_of_one() const { return (form_ & wide_form) != 0 ? 2 : 1; }
    std::uint32_t words_of_point() const { return words_of_one() << ((form_ & single_form) != 0 ? 0 : 1); }
    Point point_at(const std::uint32_t* at) const;
    [[gnu::cold, gnu::noinline]] Point wide_point(ProgressXY progress);

    std::uint32_t form_;
    const std::uint32_t* at_;
    const std::uint32_t* hub_ = nullptr;
    std::uint32_t flags_ = 0; ///< of the stroke
    std::uint32_t read_ = 0;  ///< segments of it
    std::uint32_t kinds_ = 0; ///< of up to 32 of them
};

/// The drawings at two offsets in a scene's section of drawings, made equal, from a cache in which they are
/// kept from now on; none if they find no room. The offsets may be the same. What is read is valid until the
/// cache is written again.
std::optional<TweenReader> kept_tween(PictureCache& cache, std::span<const std::byte> drawings,
                                      std::uint32_t from, std::uint32_t to);

}
