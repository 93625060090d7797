#include "core/pose/tween_cache.hpp"

#include "core/pose/posed_bones.hpp"

#include <algorithm>
#include <cstdlib>

namespace kfast {
namespace {

constexpr std::uint32_t name_of_tweens = 0xFFFF'FFFF; ///< other names have another number there

Fixed wide(std::uint32_t word) { return Fixed::from_raw(static_cast<std::int32_t>(word)); }

}

/// Writes two drawings as TweenReader reads them.
class TweenWriter {
public:
    TweenWriter(PictureCache& cache, bool is_single, bool is_wide)
        : cache_{cache},
          form_{(is_single ? TweenReader::single_form : 0) | (is_wide ? TweenReader::wide_form : 0)}
    {
    }

    /// Returns whether all of it found room, and fits in short coordinates unless they are wide. `pair` has
    /// not been read.
    [[gnu::cold]] bool write(EqualizedPair<DeformedDrawing>& pair)
    {
        add(1);
        std::uint32_t strokes = 0;
        while (const std::uint32_t segments = fits_ ? pair.next_stroke() : 0) {
            write_stroke(pair, segments);
            ++strokes;
        }
        if (!fits_)
            return false;
        is_plain_ = is_plain_ && pair.is_plain();
        cache_.incoming()[0] = form_ | strokes | (is_plain_ ? TweenReader::plain_form : 0);
        return true;
    }

    /// Whether coordinates are too large, or too fine, for short ones.
    bool is_too_short() const { return !is_short_; }

private:
    [[gnu::cold]] void write_stroke(EqualizedPair<DeformedDrawing>& pair, std::uint32_t segments)
    {
        const std::size_t head = written_;
        add(1);
        const Pair<Segment>& both = pair.next_segment();
        const Pair<Point> first{both.a.from, both.b.from};
        const bool is_part = !pair.is_whole();
        if (is_part)
            write(pair.hub());
        write(first);
        for (std::uint32_t i = 0; i < segments && fits_; ++i) {
            if (i != 0)
                pair.next_segment();
            write_segment(both, i);
        }
        const bool a_meets = first.a == both.a.to;
        const bool b_meets = first.b == both.b.to;
        is_plain_ = is_plain_ && (a_meets == (a_meets && b_meets));
        if (fits_)
            cache_.incoming()[head] = segments | (is_part ? TweenReader::part_flag : 0) |
                                      (a_meets && b_meets && !is_part ? TweenReader::closed_flag : 0);
    }

    [[gnu::cold]] void write_segment(const Pair<Segment>& both, std::uint32_t number)
    {
        const std::uint32_t bit = number % TweenReader::kinds_in_word;
        if (bit == 0) {
            kinds_ = written_;
            if (std::uint32_t* const word = add(1))
                *word = 0;
        }
        if (both.a.kind == Segment::Kind::cubic) {
            if (fits_)
                cache_.incoming()[kinds_] |= 1U << bit;
            write({both.a.c1, both.b.c1});
            write({both.a.c2, both.b.c2});
        }
        write({both.a.to, both.b.to});
    }

    [[gnu::cold]] void write(const Pair<Point>& both)
    {
        const bool is_wide = (form_ & TweenReader::wide_form) != 0;
        const bool is_single = (form_ & TweenReader::single_form) != 0;
        is_short_ = is_short_ && (is_wide || are_short(both));
        std::uint32_t* out = is_short_ ? add((is_wide ? 2U : 1U) * (is_single ? 1U : 2U)) : nullptr;
        fits_ = out != nullptr;
        if (!fits_)
            return;
        out = put(both.a, is_wide, out);
        if (!is_single)
            put(both.b, is_wide, out);
    }

    static std::uint32_t* put(Point point, bool is_wide, std::uint32_t* out)
    {
        const auto x = static_cast<std::uint32_t>(point.x.raw());
        const auto y = static_cast<std::uint32_t>(point.y.raw());
        if (is_wide) {
            *out++ = x;
            *out++ = y;
        } else {
            constexpr int bits = 16 - TweenReader::short_bits;
            *out++ = (x >> bits & 0xFFFF) | y >> bits << 16;
        }
        return out;
    }

    static bool are_short(const Pair<Point>& both)
    {
        return are_short(both.a.x, both.b.x) && are_short(both.a.y, both.b.y);
    }

    static bool are_short(Fixed a, Fixed b)
    {
        constexpr int bits = 16 - TweenReader::short_bits;
        const auto is_short = [](std::int32_t raw) {
            return (raw & ((1 << bits) - 1)) == 0 && static_cast<std::int16_t>(raw >> bits) == raw >> bits;
        };
        return is_short(a.raw()) && is_short(b.raw()) &&
               std::abs((b.raw() - a.raw()) >> bits) <= TweenReader::max_short_difference;
    }

    [[gnu::cold]] std::uint32_t* add(std::size_t count)
    {
        std::uint32_t* const words = cache_.add(count);
        written_ += count;
        fits_ = words != nullptr;
        return words;
    }

    PictureCache& cache_;
    std::uint32_t form_;
    std::size_t written_ = 0; ///< words
    std::size_t kinds_ = 0;   ///< index of the word of kinds
    bool fits_ = true;
    bool is_short_ = true;
    bool is_plain_ = true; ///< strokes closed in the first drawing are so in the second
};

Point TweenReader::point_at(const std::uint32_t* at) const
{
    if ((form_ & wide_form) != 0)
        return {wide(at[0]), wide(at[1])};
    constexpr std::int32_t unit = Fixed::one >> short_bits;
    return {Fixed::from_raw(low(*at) * unit), Fixed::from_raw(high(*at) * unit)};
}

Point TweenReader::wide_point(ProgressXY progress)
{
    const Pair<Point> both = next_points();
    return lerp(both.a, both.b, progress.x, progress.y);
}

namespace {

/// A function of its own, so that what it is made of is on the stack only while it is made.
[[gnu::cold, gnu::noinline]] EqualizedPair<DeformedDrawing> equalized(const PictureCache::Name& name,
                                                                      std::span<const std::byte> drawings)
{
    return {drawing_at(drawings, name[0]).strokes(), drawing_at(drawings, name[1]).strokes(),
            name[0] == name[1],
            [&](bool is_second) { return DeformedDrawing{drawing_at(drawings, name[is_second ? 1 : 0])}; }};
}

/// Null if they find no room.
[[gnu::cold, gnu::noinline]] const std::uint32_t* written(PictureCache& cache, const PictureCache::Name& name,
                                                          std::span<const std::byte> drawings)
{
    for (const bool is_wide : {false, true}) {
        TweenWriter writer{cache, name[0] == name[1], is_wide};
        EqualizedPair pair = equalized(name, drawings);
        cache.begin(name, PictureCache::Incoming::replaces_next); // the previous interval's
        const bool fits = writer.write(pair);
        const std::uint32_t* const words = cache.end(fits);
        if (words != nullptr || !writer.is_too_short())
            return words;
    }
    return nullptr;
}

}

std::optional<TweenReader> kept_tween(PictureCache& cache, std::span<const std::byte> drawings,
                                      std::uint32_t from, std::uint32_t to)
{
    const PictureCache::Name name{from, to, name_of_tweens};
    const std::uint32_t* words = cache.find(name);
    if (words == nullptr)
        words = written(cache, name, drawings);
    if (words == nullptr)
        return std::nullopt;
    return TweenReader{words};
}

}
