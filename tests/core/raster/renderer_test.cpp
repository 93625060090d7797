#include "core/bytes/op_counter.hpp"
#include "core/raster/renderer.hpp"
#include "tests/core/raster/panel_model.hpp"
#include "tests/core/raster/random_picture.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace kfast::raster {
namespace {

constexpr Colour background{10, 40, 90};

/// A renderer with memory of its own, exactly as much as it asks for.
class OwnedRenderer {
public:
    OwnedRenderer(const RendererNeeds& needs, Size panel)
        : block_(Renderer::block_bytes(needs, panel) / 4),
          renderer_{needs, panel, background, std::as_writable_bytes(std::span{block_})}
    {
    }

    Renderer& operator*() { return renderer_; }
    Renderer* operator->() { return &renderer_; }

private:
    std::vector<std::uint32_t> block_;
    Renderer renderer_;
};

/// How a panel is driven.
struct Drive {
    Size panel{60, 50};
    Size granularity{1, 1};
    int rows = 8; ///< that fit into the memory for areas
    std::size_t record_bytes = 8000;
    std::size_t outline_bytes = 40000;
    int layers = 4;
    bool has_groups = false;
    bool keeps = false; ///< outlines that stay as they are
};

RendererNeeds needs_of(const Drive& drive)
{
    return {.outline_bytes = drive.outline_bytes,
            .record_bytes = drive.record_bytes,
            .steps = 200,
            .group_depth = 2};
}

template <PixelFormat format>
std::vector<std::byte> whole_picture(const RandomPicture& picture, const Drive& drive, std::mt19937& random)
{
    OwnedRenderer renderer{needs_of(drive), drive.panel};
    picture.show(*renderer, drive.has_groups);
    const std::size_t stride = row_bytes(format, drive.panel.width);
    std::vector<std::uint32_t> words(stride * static_cast<std::size_t>(drive.panel.height) / 4 + 1);
    const auto pixels =
        std::as_writable_bytes(std::span{words}).first(stride * static_cast<std::size_t>(drive.panel.height));
    for (int row = 0; row < drive.panel.height;) {
        const int rows = std::min(1 + static_cast<int>(random() % 7), drive.panel.height - row);
        renderer->draw_rows<format>(row, rows, pixels.subspan(stride * static_cast<std::size_t>(row)));
        row += rows;
    }
    return {pixels.begin(), pixels.end()};
}

/// After every picture the panel must show what a renderer draws that knows nothing of those before.
template <PixelFormat format>
void check_changes(const Drive& drive, std::uint32_t seed, int pictures)
{
    CAPTURE(seed);
    CAPTURE(static_cast<int>(format));
    std::mt19937 random{seed};
    RandomPicture picture{drive.panel, seed, drive.layers};
    OwnedRenderer renderer{needs_of(drive), drive.panel};
    PanelModel<format> panel{drive.panel, drive.granularity};
    for (int i = 0; i < pictures; ++i) {
        CAPTURE(i);
        picture.show(*renderer, drive.has_groups, drive.keeps);
        panel.take(*renderer, drive.rows);
        REQUIRE(panel.is_valid());
        const auto whole = whole_picture<format>(picture, drive, random);
        const auto differing = std::ranges::mismatch(whole, panel.pixels());
        const auto place = static_cast<std::size_t>(differing.in1 - whole.begin());
        CAPTURE(place / row_bytes(format, drive.panel.width));
        CAPTURE(place % row_bytes(format, drive.panel.width));
        REQUIRE(place == whole.size());
        picture.step();
    }
}

template <PixelFormat format>
void check_many(Drive drive, int seeds)
{
    for (int seed = 0; seed < kfast::test::rounds(seeds); ++seed) {
        drive.has_groups = seed % 3 == 0;
        drive.keeps = seed % 2 == 0;
        drive.record_bytes = seed % 4 == 0 ? 96 : seed % 4 == 1 ? 0 : 8000;
        check_changes<format>(drive, static_cast<std::uint32_t>(seed), 6);
    }
}

}

TEST_CASE("a panel shows what a whole picture would, in every format")
{
    check_many<PixelFormat::rgb565>({}, 240);
    check_many<PixelFormat::rgb565_be>({.panel = {61, 47}, .rows = 1}, 60);
    check_many<PixelFormat::rgb444>({.panel = {50, 33}, .granularity = {2, 1}, .rows = 2}, 60);
    check_many<PixelFormat::rgb666>({.panel = {33, 70}}, 60);
    check_many<PixelFormat::grey4>({.panel = {64, 40}, .granularity = {2, 1}, .rows = 3}, 60);
    check_many<PixelFormat::mono1>({.panel = {60, 45}, .granularity = {8, 8}}, 60);
    check_many<PixelFormat::mono1_dithered>({.panel = {52, 40}, .granularity = {8, 1}, .rows = 1}, 60);
}

TEST_CASE("panels may be as small as a pixel, and larger than chains reach")
{
    for (const Size panel : {Size{1, 1}, Size{3, 5}, Size{31, 2}, Size{2, 90}})
        check_many<PixelFormat::rgb565>({.panel = panel, .rows = 1}, 24);
    check_many<PixelFormat::mono1>({.panel = {8, 30}, .granularity = {8, 1}, .rows = 1}, 24);
    check_many<PixelFormat::rgb565>({.panel = {1100, 40}, .outline_bytes = 400000}, 24);
    check_many<PixelFormat::rgb565>({.panel = {40, 1300}, .outline_bytes = 400000}, 24);
}

TEST_CASE("layers may be more than there are slots")
{
    check_many<PixelFormat::rgb565>({.outline_bytes = 400000, .layers = 40}, 24);
    check_many<PixelFormat::rgb565>({.panel = {20, 300}, .outline_bytes = 400000, .layers = 60}, 12);
}

TEST_CASE("a picture without room for its outlines is drawn as far as it goes")
{
    for (const unsigned bytes : {0U, 64U, 256U, 1024U})
        check_many<PixelFormat::rgb565>({.outline_bytes = bytes}, 24);
}

TEST_CASE("a picture that has not changed sends nothing")
{
    RandomPicture picture{{60, 50}, 3, 4};
    OwnedRenderer renderer{needs_of({}), {60, 50}};
    PanelModel<PixelFormat::rgb565> panel{{60, 50}, {1, 1}};
    picture.show(*renderer, false);
    panel.take(*renderer, 8);
    const std::size_t whole = panel.sent_bytes();
    CHECK(whole == 60 * 50 * 2);
    picture.show(*renderer, false);
    panel.take(*renderer, 8);
    CHECK(panel.sent_bytes() == whole);
    renderer->forget();
    panel.take(*renderer, 8);
    CHECK(panel.sent_bytes() == 2 * whole);
}

/// Corners of an opaque layer, in pixels.
using Polygon = std::vector<std::pair<int, int>>;

Polygon polygon_of(const Rect& area)
{
    const int right = area.x + area.width;
    const int bottom = area.y + area.height;
    return {{area.x, area.y}, {right, area.y}, {right, bottom}, {area.x, bottom}};
}

void show_polygons(Renderer& renderer, const std::vector<Polygon>& polygons)
{
    renderer.picture().outlines.clear();
    renderer.picture().step_count = 0;
    std::uint32_t item = 0;
    for (const Polygon& polygon : polygons) {
        const auto level = static_cast<std::uint8_t>(255 - 60 * item);
        renderer.picture().add_layer({.colour = {level, level, level, 255}, .item = ++item}, 0, {}, [&] {
            OutlineStore& outlines = renderer.picture().outlines;
            for (const auto& [x, y] : polygon)
                outlines.add({x * grid, y * grid});
            outlines.close();
        });
    }
    renderer.begin();
}

/// A picture of a rectangle, and of a wide one below it, which stays.
void show_rectangles(Renderer& renderer, const Rect& rect)
{
    show_polygons(renderer, {polygon_of(rect), polygon_of({0, 44, 60, 6})});
}

TEST_CASE("rows that nothing reaches which has changed are not sent, and bands are passed over")
{
    class Counter : public OpCounter {
    public:
        std::uint32_t* counts_for(std::uint32_t) override { return all.data(); }
        std::uint32_t bands() const { return all[static_cast<std::size_t>(Op::band)]; }

        std::array<std::uint32_t, op_kinds> all{};
    };

    OwnedRenderer renderer{needs_of({}), {60, 50}};
    PanelModel<PixelFormat::rgb565> panel{{60, 50}, {1, 1}};
    show_rectangles(*renderer, {20, 17, 6, 2});
    panel.take(*renderer, 8);
    Counter counter;
    counter.counts = counter.all.data();
    op_counter = &counter;
    std::size_t before = panel.sent_bytes();
    show_rectangles(*renderer, {22, 17, 6, 2}); // rows 17 and 18, columns 20 to 28
    panel.take(*renderer, 8);
    CHECK(panel.sent_bytes() - before <= std::size_t{2} * 9 * 2);
    CHECK(counter.bands() == 1);
    before = panel.sent_bytes();
    show_rectangles(*renderer, {22, 18, 6, 4});
    panel.take(*renderer, 8);
    CHECK(panel.sent_bytes() - before <= std::size_t{5} * 7 * 2); // rows 17 to 21, columns 22 to 28
    CHECK(counter.bands() == 3);
    op_counter = nullptr;
}

TEST_CASE("outlines with a corner less at the origin are others")
{
    OwnedRenderer renderer{needs_of({}), {60, 50}};
    PanelModel<PixelFormat::rgb565> panel{{60, 50}, {1, 1}};
    show_polygons(*renderer, {{{0, 0}, {20, 0}, {20, 20}, {0, 20}}});
    panel.take(*renderer, 8);
    const std::size_t before = panel.sent_bytes();
    show_polygons(*renderer, {{{20, 0}, {20, 20}, {0, 20}}});
    panel.take(*renderer, 8);
    CHECK(panel.sent_bytes() > before);
}

/// All rows of what the renderer shows, from a row on.
std::vector<std::byte> rows_of(OwnedRenderer& renderer, int first_row)
{
    constexpr int rows = 50;
    constexpr std::size_t stride = 60 * 2;
    std::vector<std::uint32_t> words(stride * rows / 4);
    const auto pixels =
        std::as_writable_bytes(std::span{words}).first(stride * static_cast<std::size_t>(rows - first_row));
    renderer->draw_rows<PixelFormat::rgb565>(first_row, rows - first_row, pixels);
    return {pixels.begin(), pixels.end()};
}

TEST_CASE("what is still and long is drawn only where something moves over it")
{
    OwnedRenderer renderer{needs_of({}), {60, 50}};
    PanelModel<PixelFormat::rgb565> panel{{60, 50}, {1, 1}};
    const Polygon line{{2, 16}, {58, 19}, {58, 20}, {2, 17}};
    const auto sent_for = [&](const std::vector<Polygon>& polygons) {
        const std::size_t before = panel.sent_bytes();
        show_polygons(*renderer, polygons);
        panel.take(*renderer, 8);
        OwnedRenderer fresh{needs_of({}), {60, 50}};
        show_polygons(*fresh, polygons);
        CHECK(panel.pixels() == rows_of(fresh, 0));
        return panel.sent_bytes() - before;
    };
    sent_for({polygon_of({20, 17, 6, 2}), line});
    CHECK(sent_for({polygon_of({22, 17, 6, 2}), line}) <= std::size_t{2} * 9 * 2);
    CHECK(sent_for({polygon_of({22, 17, 16, 2}), line}) <= std::size_t{2} * 17 * 2);
    CHECK(sent_for({polygon_of({0, 0, 0, 0}), line}) <= std::size_t{2} * 17 * 2); // it vanishes
    sent_for({polygon_of({22, 17, 16, 2}), line});
    // What covers the end of the line has changed: all behind it is drawn.
    CHECK(sent_for({polygon_of({22, 16, 38, 4}), line}) >= std::size_t{20} * 2);
    CHECK(sent_for({line, polygon_of({22, 16, 38, 4})}) >= std::size_t{20} * 2);
}

TEST_CASE("rows of a picture do not go on where those of the one before ended")
{
    OwnedRenderer renderer{needs_of({}), {60, 50}};
    OwnedRenderer fresh{needs_of({}), {60, 50}};
    show_rectangles(*renderer, {5, 3, 30, 20});
    std::vector<std::uint32_t> words(60 * 8 / 2);
    renderer->draw_rows<PixelFormat::rgb565>(0, 8, std::as_writable_bytes(std::span{words}));
    show_rectangles(*renderer, {20, 12, 30, 15});
    show_rectangles(*fresh, {20, 12, 30, 15});
    CHECK(rows_of(renderer, 8) == rows_of(fresh, 8));
}

TEST_CASE("a record of bands of one height tells nothing of bands of another")
{
    OwnedRenderer renderer{needs_of({}), {60, 50}};
    OwnedRenderer fresh{needs_of({}), {60, 50}};
    PanelModel<PixelFormat::rgb565> high{{60, 50}, {8, 8}};
    show_rectangles(*renderer, {5, 3, 30, 20});
    high.take(*renderer, 8);
    rows_of(renderer, 0); // bands of four rows
    show_rectangles(*renderer, {20, 12, 30, 15});
    PanelModel<PixelFormat::rgb565> low{{60, 50}, {1, 1}}; // knows nothing: all of it must come
    low.take(*renderer, 8);
    show_rectangles(*fresh, {20, 12, 30, 15});
    CHECK(low.pixels() == rows_of(fresh, 0));
}

TEST_CASE("what was kept makes no difference to what a picture needs, nor to whether it is full")
{
    int kept = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        const Drive drive{.outline_bytes = seed % 3 == 0 ? 40000U : 1500U + seed % 16 * 200U, .layers = 6};
        RandomPicture picture{drive.panel, seed, drive.layers};
        OwnedRenderer keeping{needs_of(drive), drive.panel};
        for (int i = 0; i < 8; ++i) {
            OwnedRenderer fresh{needs_of(drive), drive.panel};
            picture.show(*keeping, false, true);
            picture.show(*fresh, false);
            const OutlineStore& outlines = keeping->picture().outlines;
            kept += outlines.keeps_layers() ? 1 : 0;
            CHECK(outlines.is_full() == fresh->picture().outlines.is_full());
            CHECK(outlines.needed_bytes() == fresh->picture().outlines.needed_bytes());
            CHECK(outlines.needed_bytes() > 0);
            picture.step();
        }
    }
    CHECK(kept > 100);
}

TEST_CASE("outlines find room in what they are said to need")
{
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        CAPTURE(seed);
        const RandomPicture picture{{60, 50}, seed, 5};
        OwnedRenderer roomy{needs_of({}), {60, 50}};
        picture.show(*roomy, false);
        REQUIRE(!roomy->picture().outlines.is_full());
        const std::size_t needed = (roomy->picture().outlines.needed_bytes() + 3) / 4 * 4;
        OwnedRenderer exact{needs_of({.outline_bytes = needed}), {60, 50}};
        picture.show(*exact, false);
        CHECK(!exact->picture().outlines.is_full());
        CHECK(exact->picture().outlines.needed_bytes() == roomy->picture().outlines.needed_bytes());
        OwnedRenderer tight{needs_of({.outline_bytes = needed - 4}), {60, 50}};
        picture.show(*tight, false);
        CHECK(tight->picture().outlines.is_full());
    }
}

}
