#include "core/raster/record.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

namespace kfast::raster {
namespace {

Chain chain_of(std::uint16_t layer, std::int16_t begin)
{
    Chain chain;
    chain.layer = layer;
    chain.begin = begin;
    chain.end = static_cast<std::int16_t>(begin + 2);
    return chain;
}

/// A record of three bands, with a chain in each: of the layers 5, 6 and 7.
class ThreeBands {
public:
    ThreeBands()
    {
        record.begin_picture();
        for (int band = 0; band != 3; ++band) {
            record.begin_band(band);
            record.add(chain_of(static_cast<std::uint16_t>(5 + band), static_cast<std::int16_t>(10 * band)));
            record.end_band();
        }
        record.begin_picture();
    }

    std::vector<Record::Border> borders = std::vector<Record::Border>(9);
    std::vector<std::uint8_t> counts = std::vector<std::uint8_t>(3);
    Record record{borders, counts};
};

void check_band(Record& record, int band, std::uint16_t layer, int begin)
{
    CAPTURE(band);
    const auto shown = record.begin_band(band);
    REQUIRE(shown.size() == 1);
    CHECK(shown[0].layer == layer);
    CHECK(shown[0].begin == begin);
    record.drop_band();
}

}

TEST_CASE("bands that are passed stay known, before and behind others")
{
    ThreeBands bands;
    bands.record.pass_band(0, {});
    CHECK(bands.record.begin_band(1).size() == 1);
    bands.record.add(chain_of(6, 11));
    bands.record.end_band();
    bands.record.pass_band(2, {});
    bands.record.begin_picture();
    check_band(bands.record, 0, 5, 0);
    check_band(bands.record, 1, 6, 11);
    check_band(bands.record, 2, 7, 20);
}

TEST_CASE("layers of bands that are passed have the numbers of their partners; what finds none is not known")
{
    ThreeBands bands;
    std::vector<PaintStep> shown(8);
    shown[5].partner = Record::max_layer + 1;
    shown[6].partner = 1;
    shown[7].partner = Record::max_layer;
    for (int band = 0; band != 3; ++band)
        bands.record.pass_band(band, shown);
    CHECK(bands.record.unknown_count(3) == 1);
    bands.record.begin_picture();
    CHECK(bands.record.begin_band(0).empty());
    bands.record.drop_band();
    check_band(bands.record, 1, 1, 10);
    check_band(bands.record, 2, Record::max_layer, 20);
}

}
