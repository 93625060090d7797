#include "host/preview/overlay/painted_items.hpp"

#include <algorithm>
#include <span>

namespace kfast {

int LayerProbe::coverage(std::size_t step, int x, int y)
{
    raster::OutlineStore outlines = player_.picture().outlines;
    raster::Band band = first_band(outlines);
    while (band.top_row() + band.row_count() <= y)
        band.advance();
    return max_coverage(band, step, y - band.top_row(), x, x + 1);
}

bool LayerProbe::covers_any(std::size_t step)
{
    raster::OutlineStore outlines = player_.picture().outlines;
    const Size panel = player_.panel();
    for (raster::Band band = first_band(outlines);; band.advance()) {
        for (int row = 0; row != band.row_count(); ++row)
            for (int x = 0; x < panel.width; x += raster::tile_columns)
                if (max_coverage(band, step, row, x, std::min(x + raster::tile_columns, panel.width)) > 0)
                    return true;
        if (band.top_row() + band.row_count() == panel.height)
            return false;
    }
}

/// The list of chains in the store is changed by walking through it, and set up anew here.
raster::Band LayerProbe::first_band(raster::OutlineStore& outlines) const
{
    outlines.rewind(outlines.band_bits());
    raster::Band band;
    band.begin(outlines, player_.picture().steps(), player_.panel());
    band.advance();
    return band;
}

/// Of the columns from `begin` to `end`, at most raster::tile_columns.
int LayerProbe::max_coverage(const raster::Band& band, std::size_t step, int row, int begin, int end)
{
    const raster::Region all{.end = static_cast<std::int16_t>(player_.panel().width), .first = band.first()};
    const FillRule rule = player_.picture().steps()[step].rule;
    int found = 0;
    raster::LayerRow layer{sums_};
    if (layer.begin(band, all, static_cast<std::uint16_t>(step), rule, begin, end - begin))
        layer.sum_up(row, [&](int, int, int coverage) { found = std::max(found, coverage); });
    return found;
}

namespace {

constexpr int half_covered = raster::full_coverage / 2;

}

PaintedItems::PaintedItems(const SceneView& scene, Size panel, Fit fit)
    : StandalonePlayer{scene, panel, fit}, probe_{player()}
{
}

std::optional<std::uint32_t> PaintedItems::path_at(Time moment, int x, int y)
{
    const Size panel = player().panel();
    if (x < 0 || y < 0 || x >= panel.width || y >= panel.height)
        return {};
    player().show_moment(moment);
    std::optional<std::uint32_t> touched;
    const std::span<const raster::PaintStep> steps = player().picture().steps();
    for (std::size_t number = steps.size(); number-- != 0;) {
        const raster::PaintStep& step = steps[number];
        if (step.kind != raster::PaintStep::Kind::layer || step.colour.opacity == 0)
            continue;
        const int coverage = probe_.coverage(number, x, y);
        if (coverage >= half_covered)
            return step.item;
        if (coverage > 0 && !touched)
            touched = step.item;
    }
    return touched;
}

}
