#include "host/compiler/limits/outline_needs.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/compiler/limits/allowance.hpp"
#include "host/compiler/limits/largest_texts.hpp"
#include "host/compiler/limits/measured_moments.hpp"
#include "host/compiler/limits/outline_excess.hpp"
#include "host/compiler/limits/outline_meter.hpp"
#include "host/compiler/write/header.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::size_t min_bytes = 64;
constexpr std::size_t min_moments = 64; ///< that are measured, however long it takes

std::uint32_t with_reserve(std::size_t bytes)
{
    const std::size_t wanted = (bytes + bytes / 8 + min_bytes) / 4 * 4;
    return static_cast<std::uint32_t>(std::min<std::size_t>(wanted, kfb::max_outline_bytes));
}

/// Each chain is a border in every band that it reaches.
std::size_t borders_of(const raster::OutlineStore& outlines)
{
    constexpr int band_rows = 1 << raster::default_band_bits;
    std::size_t borders = 0;
    outlines.each_chain([&borders](const raster::Chain& chain) {
        const int first = raster::floor_pixel(chain.top) / band_rows;
        const int last = std::max(raster::ceil_pixel(chain.bottom) - 1, 0) / band_rows;
        borders += static_cast<std::size_t>(std::max(last - first, 0)) + 1;
    });
    return borders;
}

/// Of what live drawings may need: a border for every 16 bytes, as scenes have them.
std::size_t live_borders(std::size_t bytes) { return bytes / 16; }

std::uint32_t borders_with_reserve(std::size_t borders)
{
    constexpr std::size_t min = 16;
    const std::size_t wanted = borders + borders / 16 + min;
    return static_cast<std::uint32_t>(std::min<std::size_t>(wanted, kfb::max_borders));
}

}

std::optional<OutlineNeeds> outline_needs(std::vector<std::byte> file, const scene::Scene& scene,
                                          Diagnostics& diagnostics, const ProgressCallback& on_progress)
{
    set_outline_needs(file, {.bytes = kfb::max_outline_bytes});
    const auto view = playable(file, scene, diagnostics);
    if (!view)
        return std::nullopt;
    OutlineMeter meter{*view, kfb::max_outline_bytes};
    std::vector<MeasuredMoment> moments = measured_moments(*view);
    std::size_t max = 0;
    std::size_t max_borders = 0;
    std::size_t max_cache_bytes = 0;
    const std::vector<LargestTexts> all_texts = largest_texts(*view, moments, meter);
    thin_out(moments, std::max(affordable_pictures(*view) / all_texts.size(), min_moments));
    const std::size_t steps = all_texts.size() * moments.size();
    std::size_t done = 0;
    for (const LargestTexts& texts : all_texts) {
        put_texts(texts, meter);
        for (const MeasuredMoment& measured : moments) {
            on_progress(done++, steps);
            const raster::Picture& picture = meter.picture_at(measured.moment());
            const raster::OutlineStore& outlines = picture.outlines;
            if (outlines.is_full()) {
                report_excess(scene, *view, measured.moment(), texts, diagnostics);
                return std::nullopt;
            }
            const std::size_t live = meter.live_bytes();
            const std::size_t bytes = outlines.needed_bytes() + live;
            if (bytes > kfb::max_outline_bytes) {
                report_live_excess(scene, measured.moment(), outlines.needed_bytes(), live, diagnostics);
                return std::nullopt;
            }
            max = std::max(max, bytes);
            max_borders = std::max(max_borders, borders_of(outlines) + live_borders(live));
            max_cache_bytes = std::max(max_cache_bytes, picture.cache.bytes_in_use());
        }
    }
    return OutlineNeeds{.bytes = with_reserve(max),
                        .borders = borders_with_reserve(max_borders),
                        .cache_bytes = static_cast<std::uint32_t>(
                            std::min<std::size_t>(max_cache_bytes, kfb::max_cache_bytes))};
}

}
