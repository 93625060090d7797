#include "core/raster/outline/outline_store.hpp"

#include "core/raster/band.hpp"
#include "core/raster/outline/chain.hpp"
#include "tests/core/raster/band_chains.hpp"
#include "tests/core/raster/outline/chain_lines.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <doctest/doctest.h>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace kfast::test {
namespace {

using Contour = std::vector<raster::Corner>;

constexpr Size small_panel{100, 100};
constexpr Size large_panel{4096, 4096};

raster::Corner at(int x, int y) { return {x * raster::grid, y * raster::grid}; }

/// The lines of the chains of some contours, those that run down first.
std::vector<ChainLine> stored(const std::vector<Contour>& contours, Size panel = small_panel)
{
    OwnedOutlines outlines{panel};
    for (const Contour& contour : contours)
        outlines.add(contour);
    REQUIRE(!outlines.store().is_full());
    std::vector<ChainLine> lines = lines_of(outlines.store());
    std::ranges::stable_sort(lines, std::greater<>{}, &ChainLine::winding);
    return lines;
}

Contour random_contour(std::mt19937& random, int low, int high)
{
    std::uniform_int_distribution<int> place{low * raster::grid, high * raster::grid};
    Contour contour(3 + random() % 6);
    for (raster::Corner& corner : contour) {
        corner.x = place(random);
        corner.y = place(random);
    }
    return contour;
}

TEST_CASE("a contour falls into chains that do not turn back")
{
    const auto lines = stored({{at(0, 10), at(10, 20), at(10, 30), at(0, 40), at(-10, 20)}});
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].winding == 1);
    CHECK(lines[0].corners.front() == at(0, 10));
    CHECK(lines[0].corners[10] == at(10, 20));
    CHECK(lines[0].corners[20] == at(10, 30));
    CHECK(lines[0].corners.back() == at(0, 40));
    CHECK(lines[1].winding == -1);
    CHECK(lines[1].corners.front() == at(0, 10));
    CHECK(lines[1].corners[10] == at(-10, 20));
    CHECK(lines[1].corners.back() == at(0, 40));
}

TEST_CASE("a chain belongs to the layer that was begun last, and runs as the contour was drawn")
{
    OwnedOutlines outlines{small_panel};
    outlines.add({at(0, 0), at(5, 5), at(0, 9)});
    outlines.store().begin_layer({}, 7);
    outlines.add({at(0, 9), at(5, 5), at(0, 0)});
    const auto lines = lines_of(outlines.store());
    REQUIRE(lines.size() == 4);
    int windings = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(int{lines[i].layer} == (i < 2 ? 0 : 7));
        windings += lines[i].winding * (lines[i].corners[5].x > 0 ? 1 : 10) * (i < 2 ? 1 : 100);
    }
    CHECK(windings == 1 - 10 - 100 + 1000);
}

TEST_CASE("level edges end no chain and begin none")
{
    CHECK(stored({{at(0, 0), at(10, 0), at(10, 5), at(20, 5), at(20, 9), at(0, 9)}}).size() == 2);
    CHECK(stored({{at(0, 3), at(9, 3), at(4, 3)}}).empty());
    CHECK(stored({{at(3, 3)}}).empty());
    CHECK(stored({{}}).empty());
}

TEST_CASE("a level edge within a chain is kept")
{
    const auto lines = stored({{at(10, 0), at(10, 5), at(20, 5), at(20, 9), at(0, 9), at(0, 0)}});
    REQUIRE(lines.size() == 2);
    const Contour& corners = lines[0].corners;
    CHECK(corners[4] == at(10, 4));
    CHECK(corners[5] == at(10, 5));
    CHECK(corners[6] == at(20, 5));
    CHECK(corners[7] == at(20, 6));
}

TEST_CASE("a level edge at a turn belongs to the chain before it")
{
    const std::int32_t top = raster::grid / 2;
    const std::int32_t bottom = 9 * raster::grid + raster::grid / 2;
    const raster::Corner upper_right{10 * raster::grid, top};
    const raster::Corner lower_left{0, bottom};
    const auto lines = stored({{upper_right, {10 * raster::grid, bottom}, lower_left, {0, top}}});
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].corners.front() == upper_right);
    CHECK(lines[0].corners.back() == lower_left);
    CHECK(lines[1].corners.front() == upper_right);
    CHECK(lines[1].corners.back() == lower_left);
}

TEST_CASE("corners added behind follow those added, the last one first")
{
    OwnedOutlines outlines{small_panel};
    outlines.store().add(at(0, 0));
    outlines.store().add_behind(at(1, 0));
    outlines.store().add(at(0, 5));
    outlines.store().add_behind(at(1, 5));
    outlines.store().add_behind(at(3, 7));
    outlines.store().close();
    OwnedOutlines expected{small_panel};
    expected.add({at(0, 0), at(0, 5), at(3, 7), at(1, 5), at(1, 0)});
    CHECK(lines_of(outlines.store()) == lines_of(expected.store()));
}

TEST_CASE("what lies above and below the panel is left out")
{
    CHECK(stored({{at(0, -20), at(10, -10), at(-10, 0)}}).empty());
    CHECK(stored({{at(0, 100), at(10, 110), at(-10, 120)}}).empty());
    const auto lines = stored({{at(50, -10), at(90, 110), at(10, 50)}});
    REQUIRE(lines.size() == 3);
    for (const ChainLine& line : lines) {
        CHECK(line.corners.front().y >= 0);
        CHECK(line.corners.back().y <= 100 * raster::grid);
    }
    CHECK(std::ranges::any_of(lines, [](const ChainLine& line) {
        return line.corners.size() == 101 && line.corners[20] == at(60, 20) && line.corners[80] == at(80, 80);
    }));
}

TEST_CASE("what lies far to the left or right winds around the panel's points as it must")
{
    for (const Size panel : {Size{100, 100}, Size{600, 50}, Size{50, 1500}, large_panel}) {
        const int x = panel.width / 2;
        const int y = panel.height / 2;
        const int far = 16000;
        const Contour left{at(-far, -far), at(x, -far), at(x, far), at(-far, far)};
        const Contour right{at(x, -far), at(far, -far), at(far, far), at(x, far)};
        const Contour wedge{at(-far, y), at(far, y - 5), at(far, y + 5)};
        CHECK(winding_at(stored({left}, panel), {x - 1.0, y + 1.0}) == -1);
        CHECK(winding_at(stored({left}, panel), {x + 1.0, y + 1.0}) == 0);
        CHECK(winding_at(stored({right}, panel), {x + 1.0, 1.0}) == -1);
        CHECK(winding_at(stored({right}, panel), {x - 1.0, panel.height - 1.0}) == 0);
        CHECK(winding_at(stored({wedge}, panel), {x + 0.5, y + 0.0}) == -1);
        CHECK(winding_at(stored({wedge}, panel), {x + 0.5, y - 4.0}) == 0);
    }
}

TEST_CASE("what finds no room is told, and leaves the memory around it alone")
{
    constexpr std::uint32_t mark = 0xA5A5'5A5A;
    constexpr std::size_t guard = 16;
    std::mt19937 random{9};
    for (int round = 0; round < rounds(200); ++round) {
        std::vector<Contour> contours;
        for (std::size_t i = 0; i < 1 + random() % 4; ++i)
            contours.push_back(round % 4 == 0 ? random_contour(random, -3000, 3000)
                                              : random_contour(random, -20, 120));
        const std::size_t words = random() % 300;
        std::vector<std::uint32_t> memory(words + 2 * guard, mark);
        std::vector<std::uint32_t> heads(25);
        const auto borrowed = std::span{memory}.subspan(guard, words);
        raster::OutlineStore store{std::as_writable_bytes(borrowed), heads, small_panel, 2};
        store.begin_layer({}, 0);
        for (const Contour& contour : contours) {
            for (const raster::Corner corner : contour)
                random() % 2 == 0 ? store.add(corner) : store.add_behind(corner);
            store.close();
        }
        CHECK((store.is_full() || store.needed_bytes() <= 4 * words));
        CHECK(std::ranges::count(memory, mark) >= static_cast<std::ptrdiff_t>(2 * guard));
        CHECK(std::ranges::all_of(std::span{memory}.first(guard), [](auto word) { return word == mark; }));
        CHECK(std::ranges::all_of(std::span{memory}.last(guard), [](auto word) { return word == mark; }));
        std::size_t bytes = 0;
        store.each_chain(
            [&bytes](const raster::Chain& chain) { bytes += raster::OutlineStore::chain_bytes(chain); });
        CHECK(bytes <= 4 * words);
    }
}

void add_all(OwnedOutlines& outlines, const std::vector<Contour>& contours)
{
    for (const Contour& contour : contours)
        outlines.add(contour);
}

/// The least memory in which the contours are stored is what is said to be needed.
void check_needed_bytes(const std::vector<Contour>& contours, Size panel)
{
    OwnedOutlines roomy{panel};
    add_all(roomy, contours);
    const std::size_t needed = roomy.store().needed_bytes();
    REQUIRE(!roomy.store().is_full());
    REQUIRE(needed % 4 == 0);
    OwnedOutlines exact{panel, needed};
    add_all(exact, contours);
    CHECK(!exact.store().is_full());
    CHECK(exact.store().needed_bytes() == needed);
    CHECK(lines_of(exact.store()) == lines_of(roomy.store()));
    if (needed == 0)
        return;
    OwnedOutlines tight{panel, needed - 4};
    add_all(tight, contours);
    CHECK(tight.store().is_full());
}

TEST_CASE("outlines find room in just what is said to be needed")
{
    std::mt19937 random{10};
    for (int round = 0; round < rounds(500); ++round) {
        CAPTURE(round);
        std::vector<Contour> contours;
        for (std::size_t i = 0; i < 1 + random() % 4; ++i)
            contours.push_back(random_contour(random, -20, 120));
        check_needed_bytes(contours, small_panel);
    }
}

TEST_CASE("so do those that reach far out, and those of large panels")
{
    std::mt19937 random{11};
    for (int round = 0; round < rounds(500); ++round) {
        CAPTURE(round);
        check_needed_bytes({random_contour(random, -3000, 3000), random_contour(random, -20, 120)},
                           small_panel);
        check_needed_bytes({random_contour(random, -300, 4400)}, large_panel);
    }
}

TEST_CASE("clear() forgets all, also that there was no room")
{
    OwnedOutlines outlines{small_panel, 100};
    outlines.add({at(0, 0), at(5, 90), at(0, 9)});
    CHECK(outlines.store().is_full());
    outlines.store().clear();
    CHECK(!outlines.store().is_full());
    CHECK(outlines.store().needed_bytes() == 0);
    CHECK(lines_of(outlines.store()).empty());
    for (int band = 0; band < 25; ++band)
        CHECK(outlines.store().first_in(band) == raster::Chain::none);
}

TEST_CASE("when bands have gone through the chains, rewind() puts them back")
{
    std::mt19937 random{12};
    for (int round = 0; round < rounds(100); ++round) {
        OwnedOutlines outlines{small_panel, 1 << 16, 0};
        for (int i = 0; i < 3; ++i)
            outlines.add(random_contour(random, -20, 120));
        const auto lines = lines_of(outlines.store());
        for (const int bits : {0, 1, 2, 3, 2, 0}) {
            CAPTURE(bits);
            outlines.store().rewind(bits);
            CHECK(lines_of(outlines.store()) == lines);
            const auto chains = chains_of_all_bands(outlines.store(), small_panel);
            outlines.store().rewind(bits);
            CHECK(lines_of(outlines.store()) == lines);
            CHECK(chains_of_all_bands(outlines.store(), small_panel) == chains);
        }
    }
}

TEST_CASE("a band has the same chains however many bands before it were passed over")
{
    std::mt19937 random{14};
    for (int round = 0; round < rounds(100); ++round) {
        const int bits = round % (raster::max_band_bits + 1);
        OwnedOutlines outlines{small_panel, 1 << 16, bits};
        for (int i = 0; i < 3; ++i)
            outlines.add(random_contour(random, -20, 120));
        const auto chains = chains_of_all_bands(outlines.store(), small_panel);
        outlines.store().rewind(bits);
        const std::vector<raster::PaintStep> steps(1);
        raster::Band band;
        band.begin(outlines.store(), steps, small_panel);
        const int last = (small_panel.height - 1) >> bits;
        while (band.number() < last) {
            band.advance(std::min(band.number() + 1 + static_cast<int>(random() % 5), last));
            CAPTURE(band.number());
            CHECK(chains_of(band) == chains[static_cast<std::size_t>(band.number())]);
        }
    }
}

TEST_CASE("each chain comes in the band in which it begins, and only there")
{
    std::mt19937 random{13};
    for (int round = 0; round < rounds(50); ++round)
        for (int bits = 0; bits <= raster::max_band_bits; ++bits) {
            OwnedOutlines outlines{small_panel, 1 << 16, bits};
            for (int i = 0; i < 3; ++i)
                outlines.add(random_contour(random, -20, 120));
            const raster::OutlineStore& store = outlines.store();
            std::vector<const raster::Chain*> listed;
            for (int band = 0; band << bits < small_panel.height; ++band)
                for (std::uint32_t place = store.first_in(band); place != raster::Chain::none;
                     place = store.chain(place).next) {
                    listed.push_back(&store.chain(place));
                    CHECK((raster::floor_pixel(store.chain(place).top) >> bits) == band);
                }
            std::vector<const raster::Chain*> all;
            store.each_chain([&all](const raster::Chain& chain) { all.push_back(&chain); });
            std::ranges::sort(listed);
            CHECK(listed == all);
        }
}

/// Where an edge of a contour crosses a height.
struct TrueCrossing {
    double x;
    double
        near; ///< how far what is stored may lie from there: corners may be moved by half a step of the grid
    int winding; ///< to the right of it
};

/// From left to right.
std::vector<TrueCrossing> true_crossings(const Contour& contour, double y)
{
    std::vector<TrueCrossing> found;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const Spot a = spot(contour[i]);
        const Spot b = spot(contour[(i + 1) % contour.size()]);
        if ((a.y <= y) == (b.y <= y))
            continue;
        const double slope = (b.x - a.x) / (b.y - a.y);
        found.push_back({a.x + slope * (y - a.y), (2 + std::abs(slope)) / raster::grid, a.y < b.y ? 1 : -1});
    }
    std::ranges::sort(found, {}, &TrueCrossing::x);
    int winding = 0;
    for (TrueCrossing& crossing : found)
        crossing.winding = winding += crossing.winding;
    return found;
}

/// Midway between edges that are not near each other, and beside them, at a border of rows.
void check_winding_between_edges(const std::vector<ChainLine>& lines, const Contour& contour, int y,
                                 int width)
{
    const WindingRow row{lines, static_cast<double>(y)};
    TrueCrossing left{0, 0, 0};
    for (TrueCrossing right : true_crossings(contour, y)) {
        CAPTURE(right.x);
        const double begin = left.x + left.near;
        const double end = std::min<double>(right.x - right.near, width);
        if (begin < end && begin > 0) {
            CHECK(row.at(begin) == left.winding);
            CHECK(row.at((begin + end) / 2) == left.winding);
            CHECK(row.at(end) == left.winding);
        }
        if (right.x + right.near < begin)
            right.near = begin - right.x;
        left = right;
    }
}

TEST_CASE("at borders of rows outlines lie where they were drawn, also on the largest panels")
{
    std::mt19937 random{15};
    for (const Size panel : {small_panel, Size{600, 300}, Size{90, 1600}, large_panel})
        for (int round = 0; round < rounds(60); ++round) {
            CAPTURE(panel.width);
            CAPTURE(round);
            std::uniform_int_distribution<int> x{-50 * raster::grid, (panel.width + 50) * raster::grid};
            std::uniform_int_distribution<int> y{-50 * raster::grid, (panel.height + 50) * raster::grid};
            Contour contour(3 + random() % 5);
            for (raster::Corner& corner : contour) {
                corner.x = x(random);
                corner.y = y(random);
            }
            const auto lines = stored({contour}, panel);
            for (int row = 0; row < panel.height; row += 1 + panel.height / 300)
                check_winding_between_edges(lines, contour, row, panel.width);
        }
}

}
}
