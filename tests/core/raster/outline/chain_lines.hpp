#pragma once

#include "core/raster/outline/outline_store.hpp"
#include "tests/core/spot.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast::test {

/// What is kept of a chain: its ends, crossings and bends, from the top down, on the panel.
struct ChainLine {
    std::vector<raster::Corner> corners;
    int winding; ///< around what lies to the right of it
    std::uint16_t layer;

    friend bool operator==(const ChainLine&, const ChainLine&) = default;
};

/// Its crossings, of a chain that no band has gone through since the last rewind().
inline std::vector<raster::Crossing> crossings_of(const raster::OutlineStore& store,
                                                  const raster::Chain& chain)
{
    const int first = raster::floor_pixel(chain.top);
    const int last = raster::ceil_pixel(chain.bottom);
    std::vector<raster::Crossing> crossings;
    for (int row = first; row <= last; ++row) {
        const int band = (first >> store.band_bits()) << store.band_bits();
        crossings.emplace_back();
        if (chain.is_straight)
            raster::find_crossings(chain, store.line(chain), row, 0, &crossings.back());
        else
            crossings.back() = store.crossing(chain.crossings)[row - band];
    }
    return crossings;
}

inline ChainLine line_of(const raster::OutlineStore& store, const raster::Chain& chain)
{
    ChainLine line{{}, chain.runs_down ? 1 : -1, chain.layer};
    const std::int32_t left = chain.left * raster::grid;
    const std::int32_t origin = chain.top & -raster::grid;
    const auto add = [&](std::int32_t x, std::int32_t y) { line.corners.push_back({left + x, y}); };
    const raster::Bend* bend = store.bend(chain.bends);
    const std::vector<raster::Crossing> crossings = crossings_of(store, chain);
    add(crossings[0], chain.top);
    for (std::size_t i = 1; i < crossings.size(); ++i) {
        const std::int32_t border = origin + static_cast<std::int32_t>(i) * raster::grid;
        const std::int32_t end = border < chain.bottom ? border : chain.bottom;
        for (; bend->y <= end - origin; --bend)
            add(bend->x, origin + bend->y);
        add(crossings[i], end);
    }
    return line;
}

/// Of all chains, the last one that was added first.
inline std::vector<ChainLine> lines_of(const raster::OutlineStore& store)
{
    std::vector<ChainLine> lines;
    store.each_chain([&](const raster::Chain& chain) { lines.push_back(line_of(store, chain)); });
    return lines;
}

/// x where a chain that reaches there passes; at a border of rows it is what is stored for it.
inline double x_at(const ChainLine& line, double y)
{
    Spot below = spot(line.corners.back());
    for (std::size_t i = line.corners.size() - 1; i-- > 0;) {
        const Spot above = spot(line.corners[i]);
        if (above.y <= y)
            return above.x + (below.x - above.x) * (y - above.y) / (below.y - above.y);
        below = above;
    }
    return below.x;
}

/// Winding numbers around the points of a row, of outlines of all layers.
class WindingRow {
public:
    WindingRow(const std::vector<ChainLine>& lines, double y)
    {
        for (const ChainLine& line : lines)
            if (y >= spot(line.corners.front()).y && y < spot(line.corners.back()).y)
                passes_.push_back({x_at(line, y), line.winding});
    }

    int at(double x) const
    {
        int winding = 0;
        for (const Pass& pass : passes_)
            winding += pass.x < x ? pass.winding : 0;
        return winding;
    }

private:
    struct Pass {
        double x;
        int winding;
    };

    std::vector<Pass> passes_;
};

inline int winding_at(const std::vector<ChainLine>& lines, Spot at)
{
    return WindingRow{lines, at.y}.at(at.x);
}

/// Whether outlines overlap within a pixel so that their areas do not add up to what they enclose by the rule
/// nonzero.
inline bool overlap_within(const std::vector<ChainLine>& lines, int x, int y)
{
    constexpr int samples = 12;
    int min = 0;
    int max = 0;
    bool is_first = true;
    for (int j = 0; j < samples; ++j) {
        const WindingRow row{lines, y + (j + 0.5) / samples};
        for (int i = 0; i < samples; ++i) {
            const int winding = row.at(x + (i + 0.5) / samples);
            min = is_first ? winding : std::min(min, winding);
            max = is_first ? winding : std::max(max, winding);
            is_first = false;
        }
    }
    return max - min > 1 || (min < 0 && max > 0);
}

/// Outlines in memory of their own.
class OwnedOutlines {
public:
    explicit OwnedOutlines(Size panel, std::size_t bytes = 1 << 20, int band_bits = 2)
        : memory_(bytes / 4),
          heads_(static_cast<std::size_t>(panel.height)),
          store_{std::as_writable_bytes(std::span{memory_}), heads_, panel, band_bits}
    {
        store_.begin_layer({}, 0);
    }

    raster::OutlineStore& store() { return store_; }
    const raster::OutlineStore& store() const { return store_; }

    void add(const std::vector<raster::Corner>& contour)
    {
        for (const raster::Corner corner : contour)
            store_.add(corner);
        store_.close();
    }

private:
    std::vector<std::uint32_t> memory_;
    std::vector<std::uint32_t> heads_;
    raster::OutlineStore store_;
};

}
