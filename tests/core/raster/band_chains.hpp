#pragma once

#include "core/raster/band.hpp"
#include "core/raster/outline/outline_store.hpp"

#include <algorithm>
#include <vector>

namespace kfast::test {

/// Where the band's chains cross its borders of rows, and what they touch, from left to right.
inline std::vector<std::vector<int>> chains_of(const raster::Band& band)
{
    std::vector<std::vector<int>> chains;
    for (std::uint32_t place = band.first(); place != raster::Chain::none; place = band.chain(place).next) {
        const raster::Chain& chain = band.chain(place);
        std::vector<int> own{chain.begin, chain.end, chain.height, chain.is_whole};
        const int from = std::max(raster::floor_pixel(chain.top), band.top_row()) - band.top_row();
        const int to = std::min(raster::ceil_pixel(chain.bottom) - band.top_row(), band.row_count());
        for (int row = from; row <= to; ++row)
            own.push_back(*band.crossings(chain, row) + chain.left * raster::grid);
        chains.push_back(own);
    }
    std::ranges::sort(chains);
    return chains;
}

inline std::vector<std::vector<std::vector<int>>> chains_of_all_bands(const raster::OutlineStore& store,
                                                                      Size panel)
{
    const std::vector<raster::PaintStep> steps(8);
    std::vector<std::vector<std::vector<int>>> chains;
    raster::Band band;
    band.begin(store, steps, panel);
    do {
        band.advance();
        chains.push_back(chains_of(band));
    } while (band.top_row() + band.row_count() != panel.height);
    return chains;
}

}
