#include "core/bytes/bump_allocator.hpp"
#include "core/raster/renderer.hpp"

namespace kfast::raster {
namespace {

/// The number of bands of a panel so narrow that a row of it may have no room for 4 rows of 8 pixels.
constexpr int band_count(Size panel)
{
    constexpr int narrow = max_granularity.width << default_band_bits;
    return panel.width < narrow ? panel.height
                                : (panel.height + (1 << default_band_bits) - 1) >> default_band_bits;
}

constexpr std::size_t whole_words(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

/// How the lent block is divided.
struct BlockPlan {
    std::size_t outlines; ///< bytes of each part
    std::size_t cache;
    std::size_t steps;
    std::size_t heads;
    std::size_t backdrops;
    std::size_t record;
    std::size_t counts;
    std::size_t changed;

    BlockPlan(const RendererNeeds& needs, Size panel)
        : outlines{needs.outline_bytes},
          cache{needs.cache_bytes},
          steps{needs.steps * sizeof(PaintStep)},
          heads{static_cast<std::size_t>(band_count(panel)) * 4},
          backdrops{needs.group_depth * tile_bytes},
          record{whole_words(needs.record_bytes)},
          counts{whole_words(static_cast<std::size_t>(band_count(panel)))},
          changed{BandSet::words_for(band_count(panel)) * 4}
    {
    }

    std::size_t size() const
    {
        return outlines + cache + 2 * steps + heads + backdrops + record + counts + changed;
    }
};

}

std::size_t Renderer::block_bytes(const RendererNeeds& needs, Size panel)
{
    return BlockPlan{needs, panel}.size();
}

Renderer::Renderer(const RendererNeeds& needs, Size panel, Colour background, std::span<std::byte> block)
    : panel_{panel}
{
    const BlockPlan plan{needs, panel};
    BumpAllocator cutter{block};
    const std::span<std::byte> outlines = cutter.cut(plan.outlines);
    picture_.cache = PictureCache{cutter.cut(plan.cache)};
    picture_.storage = cutter.cut_as<PaintStep>(plan.steps);
    shown_storage_ = cutter.cut_as<PaintStep>(plan.steps);
    picture_.outlines =
        OutlineStore{outlines, cutter.cut_as<std::uint32_t>(plan.heads), panel, default_band_bits};
    backdrops_ = cutter.cut(plan.backdrops);
    const auto borders = cutter.cut_as<Record::Border>(plan.record);
    record_ = Record{borders, cutter.cut_as<std::uint8_t>(plan.counts)};
    changed_ = BandSet{cutter.cut_as<std::uint32_t>(plan.changed)};
    slots_.background = background;
}

}
