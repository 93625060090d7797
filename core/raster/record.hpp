#pragma once

#include "core/bytes/expects.hpp"
#include "core/pixel/pixel_format.hpp"
#include "core/pixel/pixel_row.hpp"
#include "core/raster/cells.hpp"
#include "core/raster/outline/chain.hpp"
#include "core/raster/outline/paint_step.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace kfast::raster {

/// How the cells of a row become pixels of a panel. For a format that has `is_direct`, pixels are cells.
template <PixelFormat format>
struct Packing;

template <>
struct Packing<PixelFormat::rgb565> {
    using Cells = Rgb565Cells;
    static constexpr bool is_direct = true;
    static void finish(std::uint16_t*, std::size_t) {}
};

template <>
struct Packing<PixelFormat::rgb565_be> {
    using Cells = Rgb565Cells;
    static constexpr bool is_direct = true;
    /// Swaps the bytes of `count` pixels.
    static void finish(std::uint16_t* pixels, std::size_t count)
    {
        for (std::uint16_t* const end = pixels + count; pixels != end; ++pixels)
            *pixels = static_cast<std::uint16_t>(*pixels << 8 | *pixels >> 8);
    }
};

/// 0 … 255 in `bits` bits, rounded to nearest.
template <int bits>
constexpr std::uint32_t narrowed(std::uint32_t channel)
{
    return narrow_channel(channel & 255, (1U << bits) - 1);
}

/// The formats below pack `count` cells, from column x of row y of the panel on. x is a multiple of
/// pixels_in_whole_bytes(), and `count` is one, too, or the row ends with it.
template <>
struct Packing<PixelFormat::rgb444> {
    using Cells = Rgb888Cells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint32_t* cells, int count, std::byte* to, int, int)
    {
        for (; count > 0; count -= 2, cells += 2, to += 3) {
            const std::uint32_t left = pixel(cells[0]);
            const std::uint32_t right = count > 1 ? pixel(cells[1]) : 0;
            to[0] = static_cast<std::byte>(left >> 4);
            to[1] = static_cast<std::byte>(left << 4 | right >> 8);
            if (count > 1)
                to[2] = static_cast<std::byte>(right);
        }
    }

private:
    static constexpr std::uint32_t pixel(std::uint32_t cell)
    {
        return narrowed<4>(cell >> 16) << 8 | narrowed<4>(cell >> 8) << 4 | narrowed<4>(cell);
    }
};

template <>
struct Packing<PixelFormat::rgb666> {
    using Cells = Rgb888Cells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint32_t* cells, int count, std::byte* to, int, int)
    {
        for (; count > 0; --count, ++cells)
            for (int shift = 16; shift >= 0; shift -= 8)
                *to++ = static_cast<std::byte>(narrowed<6>(*cells >> shift) << 2);
    }
};

template <>
struct Packing<PixelFormat::grey4> {
    using Cells = GreyCells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint8_t* cells, int count, std::byte* to, int, int)
    {
        for (; count > 0; count -= 2, cells += 2)
            *to++ =
                static_cast<std::byte>(narrowed<4>(cells[0]) << 4 | (count > 1 ? narrowed<4>(cells[1]) : 0));
    }
};

/// One bit for each cell for which is_lit(brightness, x) holds, the leftmost in the highest.
template <class IsLit>
void pack_bits(const std::uint8_t* cells, int count, std::byte* to, IsLit is_lit)
{
    for (int x = 0; x < count; x += 8) {
        std::uint32_t bits = 0;
        for (int i = 0; i < 8; ++i)
            bits = bits << 1 | (x + i < count && is_lit(cells[x + i], x + i) ? 1U : 0U);
        *to++ = static_cast<std::byte>(bits);
    }
}

template <>
struct Packing<PixelFormat::mono1> {
    using Cells = GreyCells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint8_t* cells, int count, std::byte* to, int, int)
    {
        pack_bits(cells, count, to, [](std::uint32_t brightness, int) { return brightness >= 128; });
    }
};

template <>
struct Packing<PixelFormat::mono1_dithered> {
    using Cells = GreyCells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint8_t* cells, int count, std::byte* to, int x, int y)
    {
        pack_bits(cells, count, to,
                  [=](std::uint32_t brightness, int i) { return dither.is_lit(brightness, x + i, y); });
    }
};

/// What the panel shows: where the borders of layers were in each band of rows of the last picture. It is
/// read band by band while that of the next picture is written into the same memory:
///
///     | written >   free   | still to be read |
///
/// Bands that stay as they are before any other stay where they are in memory, too. A band that finds no room
/// is not known, and drawn whole the next time.
class Record {
public:
    /// A chain as it was in a band.
    struct Border {
        std::int16_t begin = 0; ///< columns, as in Chain
        std::int16_t end = 0;
        std::uint16_t layer : 11 = 0; ///< number of the step
        std::uint16_t is_border : 1 = 0;
        std::uint16_t rows : 4 = 0; ///< as in Chain
    };

    /// Bands with other layers are not known.
    static constexpr std::uint16_t max_layer = 2047;

    Record() = default;
    /// `counts` has an element for each band.
    Record(std::span<Border> borders, std::span<std::uint8_t> counts);

    /// From now on nothing is known of the panel.
    void forget();
    /// Starts again with the first band.
    void begin_picture();

    /// How many of the first `bands` are not known.
    int unknown_count(int bands) const;
    bool is_known(int band) const
    {
        expects(band >= 0 && static_cast<std::size_t>(band) < counts_.size());
        return counts_[static_cast<std::size_t>(band)] != unknown;
    }
    /// The next band, which is known, is unchanged. `shown` are the steps of that picture, whose partners
    /// are found; none if all of them have kept their numbers.
    void pass_band(int band, std::span<const PaintStep> shown);
    /// The borders of the next band, until add() is called; none if it is not known.
    std::span<const Border> begin_band(int band);
    /// Adds a chain of the band in the next picture.
    void add(const Chain& chain);
    void end_band();
    /// From now on it is not known what the panel shows of the band.
    void drop_band();

private:
    static constexpr std::uint8_t unknown = 0xFF;

    void make_room();

    std::span<Border> borders_;
    std::span<std::uint8_t> counts_;
    Border* read_ = nullptr;
    Border* read_end_ = nullptr;
    Border* written_ = nullptr;  ///< of all bands that are finished
    Border* band_end_ = nullptr; ///< the end of the band
    int band_ = 0;
    bool has_capacity_ = true; ///< whether there is room for the band
    bool is_apart_ = false;    ///< whether what is to be read is apart from what is written
};

static_assert(sizeof(Record::Border) == 6);

}
