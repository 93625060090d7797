#include "core/raster/outline/outline_store.hpp"
#include "tests/core/raster/band_chains.hpp"
#include "tests/core/raster/outline/chain_lines.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

namespace kfast::test {
namespace {

constexpr Size panel_of_layers{100, 100};

/// A triangle with corners on pixels.
std::vector<raster::Corner> triangle_of(const std::vector<raster::Corner>& pixels)
{
    std::vector<raster::Corner> corners = pixels;
    for (raster::Corner& corner : corners)
        corner = {corner.x * raster::grid, corner.y * raster::grid};
    return corners;
}

/// Adds a layer of one contour.
void add_layer(raster::OutlineStore& store, raster::LayerName name, std::uint16_t step,
               const std::vector<raster::Corner>& contour, const Dependence& dependence)
{
    store.begin_layer(name, step);
    for (const raster::Corner corner : contour)
        store.add(corner);
    store.close();
    REQUIRE(store.end_layer(dependence) != nullptr);
}

const std::vector<raster::Corner> upper = triangle_of({{10, 5}, {40, 5}, {30, 20}});
const std::vector<raster::Corner> lower = triangle_of({{20, 30}, {60, 47}, {15, 60}});
constexpr Dependence on_one_way{.keys = 0b1011, .tweens = 0b10};

TEST_CASE("layers that stay as they are can be kept, and taken into another picture")
{
    OwnedOutlines outlines{panel_of_layers};
    raster::OutlineStore& store = outlines.store();
    store.clear();
    add_layer(store, {7, 0}, 0, upper, {.keys = 0b1, .tweens = 0b1});
    add_layer(store, {7, 1}, 1, lower, on_one_way);
    add_layer(store, {8, 0}, 2, upper, on_one_way);
    const raster::Fingerprint fingerprint = [&] {
        OwnedOutlines other{panel_of_layers};
        other.store().clear();
        other.store().begin_layer({9, 0}, 0);
        other.add(lower);
        return other.store().end_layer({})->fingerprint;
    }();

    store.keep({.keys = 0b100, .tweens = 0b1});
    CHECK(store.keeps_layers());
    CHECK(lines_of(store).empty());
    CHECK(store.reuse({7, 0}, 0) == nullptr); // it does not hold any more
    CHECK(store.reuse({8, 1}, 0) == nullptr); // there was none
    const raster::LayerOutlines* const kept = store.reuse({7, 1}, 5);
    REQUIRE(kept != nullptr);
    CHECK(kept->fingerprint == fingerprint);
    CHECK(kept->rows.begin == 30);
    CHECK(kept->rows.end == 60);
    CHECK(kept->dependence == on_one_way);
    CHECK(store.reuse({7, 1}, 6) == nullptr); // it is taken
    OwnedOutlines expected{panel_of_layers};
    expected.store().begin_layer({}, 5);
    expected.add(lower);
    CHECK(lines_of(store) == lines_of(expected.store()));
    CHECK(chains_of_all_bands(store, panel_of_layers) ==
          chains_of_all_bands(expected.store(), panel_of_layers));

    store.keep({});
    CHECK(store.reuse({8, 0}, 0) == nullptr); // the picture before did not have it
    CHECK(store.reuse({7, 1}, 0) != nullptr);
    store.keep({.keys = 0b1000});
    CHECK_FALSE(store.keeps_layers());
    CHECK(store.reuse({7, 1}, 0) == nullptr);
}

TEST_CASE("nothing is kept of a picture that is not complete")
{
    OwnedOutlines outlines{panel_of_layers, 400};
    raster::OutlineStore& store = outlines.store();
    store.clear();
    add_layer(store, {1, 0}, 0, upper, {});
    store.begin_layer({2, 0}, 1);
    outlines.add(lower);
    CHECK(store.is_full());
    store.keep({});
    CHECK_FALSE(store.is_full());
    CHECK_FALSE(store.keeps_layers());
    CHECK(store.reuse({1, 0}, 0) == nullptr);
}

}
}
