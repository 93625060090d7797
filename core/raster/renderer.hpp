#pragma once

#include "core/math/point.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/pixel/pixel_format.hpp"
#include "core/raster/band.hpp"
#include "core/raster/cells.hpp"
#include "core/raster/dirty.hpp"
#include "core/raster/layer_row.hpp"
#include "core/raster/outline/picture.hpp"
#include "core/raster/record.hpp"
#include "core/raster/slots.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// The maximum number of columns and rows that a panel takes together.
inline constexpr Size max_granularity{8, 8};

/// What a scene needs of the memory of a renderer.
struct RendererNeeds {
    std::size_t outline_bytes = 0; ///< a multiple of 4
    std::size_t record_bytes = 0;  ///< too little costs bytes on the bus, not pixels
    std::size_t cache_bytes = 0;   ///< a multiple of 4; too little costs time
    std::size_t steps = 0;
    std::size_t group_depth = 0;
};

/// Draws pictures band by band (README.md).
///
///     picture() is filled -> begin() -> draw_changes() until it returns nothing, or draw_rows()
class Renderer {
public:
    static std::size_t block_bytes(const RendererNeeds& needs, Size panel);

    /// `block` is aligned to 4, has block_bytes() and must outlive the renderer.
    [[gnu::cold, gnu::noinline]] Renderer(const RendererNeeds& needs, Size panel, Colour background,
                                          std::span<std::byte> block);

    Picture& picture() { return picture_; }
    const Picture& picture() const { return picture_; }
    /// Must be called when picture() has been filled anew.
    void begin();
    /// From now on, what the panel shows is not known.
    void forget();

    /// The number of bands that are drawn whole the next time, for want of room to record what they show.
    int unrecorded_bands() const;

    /// Draws rows of the picture into rows x row_bytes(format, panel width) bytes, aligned to 2 if pixels are
    /// 16 bits. Calls for rows from the top down are cheap.
    template <PixelFormat format>
    void draw_rows(int first_row, int rows, std::span<std::byte> pixels);

    /// Draws the next areas in which the picture differs from what the panel shows; none when all is drawn,
    /// and the panel shows it. `pixels` has room for granularity.height whole rows. Positions and sizes of
    /// areas are multiples of `granularity`, but for areas that end with the panel; its sides are powers of
    /// two, no larger than those of max_granularity. `area_bytes` is what an area costs besides its pixels.
    /// Areas are valid until the next call.
    template <PixelFormat format>
    std::span<const Change> draw_changes(std::span<std::byte> pixels, Size granularity, int area_bytes);

private:
    enum class Progress : std::uint8_t { none, begun, done };

    /// The maximum number of areas in a call: the caller has other things to do in between.
    static constexpr std::size_t max_changes = 4;

    /// The number of bands of the panel, as high as they are now.
    int band_count() const;
    void begin_pass(int band_bits);
    [[gnu::cold, gnu::noinline]] void begin_changes(int band_bits);
    [[gnu::cold, gnu::noinline]] void find_changed_bands();
    void end_changes();
    [[gnu::cold, gnu::noinline]] bool assign_slots(std::span<const Record::Border> shown);
    template <class Cells>
    bool next_band(bool is_known, std::span<const Record::Border> shown);
    int next_changed_band();
    template <class Cells>
    bool next_dirty_band();
    void keep_band();
    /// A part of the band.
    struct Window {
        int begin = 0; ///< columns
        int end = 0;
        RowMask rows = 0;
    };
    Window next_window(int granularity, int gap);
    template <PixelFormat format>
    void draw_area(const Rect& area, std::span<std::byte> pixels, LayerRow& row);
    template <class Cells>
    void draw_tile(const Tile<Cells>& tile, LayerRow& row);

    Size panel_;
    Picture picture_;
    std::span<PaintStep> shown_storage_;
    std::size_t shown_count_ = 0;
    Record record_;
    BandSet changed_;                ///< bands that something reaches that is not as on the panel
    std::span<std::byte> backdrops_; ///< tile_bytes for each depth of groups
    Slots slots_;
    Band band_;
    RegionList regions_;
    CoverageSums sums_;                   ///< empty between rows of layers
    int drawn_columns_ = 0;               ///< areas to the left of this column of the band are drawn
    const Region* next_region_ = nullptr; ///< all regions before it are to the left of that
    int next_row_ = 0;                    ///< with which draw_rows() may continue
    int recorded_band_bits_ = -1;         ///< of the bands in the record
    Progress progress_ = Progress::none;
    bool is_fresh_ = false; ///< whether no pass has gone through the outlines
    bool knows_panel_ = false;
    bool has_same_numbers_ = false; ///< whether each step has the number of its partner
    std::array<Change, max_changes> changes_;
};

}
