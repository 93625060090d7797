#pragma once

#include "core/bytes/expects.hpp"
#include "core/raster/outline/chain.hpp"
#include "core/raster/outline/paint_step.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

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
