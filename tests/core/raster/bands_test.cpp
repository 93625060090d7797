#include "core/raster/band.hpp"
#include "tests/core/raster/polygons.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <vector>

/// How a picture is divided into bands and tiles changes nothing.
namespace kfast::test {
namespace {

/// With bands of every height, tiles of some widths, and by edges where these tell the coverage.
void expect_same_in_all_ways(const std::vector<Polygon>& polygons, Size size, FillRule rule,
                             std::mt19937& random)
{
    CoveragePicture picture = filled(size, polygons, rule);
    const std::vector<int> expected = picture.levels();
    for (int band_bits = 0; band_bits <= raster::max_band_bits; ++band_bits)
        for (const bool by_edges : {false, true}) {
            const int columns = 1 + static_cast<int>(random() % raster::tile_columns);
            CAPTURE(band_bits);
            CAPTURE(columns);
            picture.draw(rule, {.band_bits = band_bits, .columns = columns, .by_edges = by_edges});
            REQUIRE(picture.levels() == expected);
        }
}

TEST_CASE("a pixel is covered the same, however the picture is divided into bands and tiles")
{
    std::mt19937 random{3};
    std::uniform_real_distribution<double> place{0, 60};
    for (int round = 0; round < rounds(200); ++round) {
        std::vector<Polygon> polygons;
        for (std::size_t i = 0; i < 1 + random() % 6; ++i)
            polygons.push_back(random() % 4 == 0
                                   ? random_polygon(random, -10, 70)
                                   : disc(place(random), place(random), 12 + place(random) / 2));
        expect_same_in_all_ways(polygons, {70, 60}, rule_of(round), random);
    }
    for (int round = 0; round < rounds(500); ++round) { // chains begin and meet in the same places
        constexpr int unit = raster::grid;
        expect_same_in_all_ways(
            {random_polygon(random, 0, 24, unit, unit), random_polygon(random, 0, 24, unit, unit)}, {24, 24},
            rule_of(round), random);
    }
    for (int round = 0; round < rounds(100); ++round)
        expect_same_in_all_ways({random_polygon(random, -900, 900), random_polygon(random, -900, 900)},
                                {80, 80}, rule_of(round), random);
    for (int round = 0; round < rounds(20); ++round)
        expect_same_in_all_ways({random_polygon(random, -10, 610)}, {600, 120}, rule_of(round), random);
}

/// Whether a chain of the band touches a column.
std::vector<bool> touched_columns(const raster::Band& band, int width)
{
    std::vector<bool> touched(static_cast<std::size_t>(width));
    for (std::uint32_t place = band.first(); place != raster::Chain::none; place = band.chain(place).next)
        for (int x = band.chain(place).begin; x < std::min<int>(band.chain(place).end, width); ++x)
            touched[static_cast<std::size_t>(x)] = true;
    return touched;
}

void expect_even_between_chains(CoveragePicture& picture, int band_bits)
{
    picture.draw(FillRule::nonzero, {.band_bits = band_bits});
    picture.store().rewind(band_bits);
    const std::vector<raster::PaintStep> steps(1);
    raster::Band band;
    band.begin(picture.store(), steps, {picture.width(), picture.height()});
    for (int top = 0; top < picture.height(); top += 1 << band_bits) {
        band.advance();
        const std::vector<bool> touched = touched_columns(band, picture.width());
        for (int y = top; y < top + band.row_count(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (!touched[static_cast<std::size_t>(x)])
                    REQUIRE((picture.at(x, y) == picture.at(x, top) && picture.at(x, y) % full == 0));
    }
}

TEST_CASE("between the columns of its chains, a band is covered wholly or not at all, and in all rows alike")
{
    std::mt19937 random{31};
    for (int round = 0; round < rounds(300); ++round) {
        const int rows = round % 3 == 0 ? 70 : 30;
        CoveragePicture picture{30, rows};
        add(picture, {random_polygon(random, -5, 35), random_polygon(random, -5, rows, 1, 64),
                      random_polygon(random, 0, 30, 64)});
        for (int band_bits = 0; band_bits <= raster::max_band_bits; ++band_bits)
            expect_even_between_chains(picture, band_bits);
    }
}

}
}
