#include "tests/core/raster/outline/chain_lines.hpp"

#include <algorithm>
#include <cstdint>
#include <doctest/doctest.h>
#include <optional>
#include <span>
#include <vector>

/// Contours that an OutlineStore places.
namespace kfast::test {
namespace {

using raster::ContourCache;
using raster::ContourName;
using raster::Corner;
using raster::CornerMap;

/// A quarter turn and a shift by so many pixels.
CornerMap turned(int x)
{
    return {0, -(1 << CornerMap::fraction_bits), 1 << CornerMap::fraction_bits, 0, x << 16, 3 << 16};
}

/// The outlines of a layer with one square, whose sides have a corner in their middle.
struct Placed {
    explicit Placed(const CornerMap& map, std::optional<ContourName> name = {}, ContourCache* cache = nullptr)
        : outlines{Size{100, 100}}
    {
        raster::OutlineStore& store = outlines.store();
        store.place_contours(map, name ? &*name : nullptr, cache);
        if (cache == nullptr ||
            !cache->each_contour(*name, [&](const raster::KeptContour& contour) { store.add(contour); })) {
            if (cache != nullptr)
                cache->begin(*name);
            outlines.add({{0, 0}, {0, -500}, {0, -1000}, {500, -1001}, {1000, -1000}, {1000, 0}});
            if (cache != nullptr)
                cache->end(true);
        }
        store.end_placed();
        fingerprint = store.end_layer({})->fingerprint;
    }

    OwnedOutlines outlines;
    raster::Fingerprint fingerprint;
};

TEST_CASE("contours are placed, also where they come from a cache, and take the same room")
{
    std::vector<std::uint32_t> memory(100);
    PictureCache pictures{std::as_writable_bytes(std::span{memory})};
    ContourCache cache{pictures};
    const ContourName name{.drawing = 3};
    const Placed first{turned(10), name, &cache};
    const Placed kept{turned(10), name, &cache};
    CHECK(pictures.bytes_in_use() == 16 + 4 + 4 * 4); // no corners in the middle of a side
    const std::vector<ChainLine> lines = lines_of(first.outlines.store());
    REQUIRE(lines.size() == 2);
    const Corner left{10 * raster::grid, 3 * raster::grid};
    for (const ChainLine& line : lines) {
        CHECK(line.corners.front().y == left.y);
        CHECK(std::ranges::min(line.corners, {}, &Corner::x).x >= left.x);
    }
    CHECK(lines_of(kept.outlines.store()) == lines);
    CHECK(kept.outlines.store().needed_bytes() == first.outlines.store().needed_bytes());
}

TEST_CASE("names and places tell contours apart, and so do corners without a name")
{
    const ContourName name{.drawing = 3};
    const Placed first{turned(10), name};
    CHECK(Placed{turned(10), name}.fingerprint == first.fingerprint);
    CHECK_FALSE(Placed{turned(11), name}.fingerprint == first.fingerprint);
    CHECK_FALSE(Placed{turned(10), ContourName{.drawing = 4}}.fingerprint == first.fingerprint);
    CHECK_FALSE(Placed{turned(10), ContourName{.drawing = 3, .half_width = 0}}.fingerprint ==
                first.fingerprint);
    CHECK_FALSE(Placed{turned(10), ContourName{.drawing = 3, .scale_bits = 1}}.fingerprint ==
                first.fingerprint);
    CHECK_FALSE(Placed{turned(10), ContourName{.drawing = 3, .coarseness = 1}}.fingerprint ==
                first.fingerprint);
    CHECK_FALSE(Placed{turned(10)}.fingerprint == Placed{turned(11)}.fingerprint);
    CHECK(Placed{turned(10)}.fingerprint == Placed{turned(10)}.fingerprint);
}

}
}
