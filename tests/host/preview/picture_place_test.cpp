#include "host/preview/panes/picture_pane.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr Rect pane{100, 50, 400, 300};

}

TEST_CASE("zoom 0 shows the whole picture in whole pixels, with a margin")
{
    CHECK(PictureLayout({100, 100}, pane, 0).rect() == Rect{150, 50, 300, 300});
    CHECK(PictureLayout({100, 100}, pane, 0, {}, 12).rect() == Rect{200, 100, 200, 200});
    CHECK(PictureLayout({800, 600}, pane, 0).scale() == 0.5);
    CHECK(PictureLayout({100, 100}, {0, 0, 1, 1}, 0, {}, 50).rect() == Rect{0, 0, 1, 1});
    CHECK(PictureLayout({100, 100}, {0, 0, 0, 0}, 0).rect() == Rect{0, 0, 1, 1});
}

TEST_CASE("a zoomed picture is centred, and moved only as far as it goes beyond the pane")
{
    CHECK(PictureLayout({100, 100}, pane, 2, {50, 50}).rect() == Rect{200, 100, 200, 200});
    CHECK(PictureLayout({100, 100}, pane, 4).rect() == Rect{100, 0, 400, 400});
    CHECK(PictureLayout({100, 100}, pane, 4, {10, 1000}).rect() == Rect{100, 50, 400, 400});
    CHECK(PictureLayout({100, 100}, pane, 4, {10, -1000}).rect() == Rect{100, -50, 400, 400});
    CHECK(PictureLayout({100, 100}, pane, 4, {10, 1000}).pan().y == 50);
    CHECK(PictureLayout({100, 100}, pane, 4, {10, 1000}).pan().x == 0);
}

TEST_CASE("places of the window and of the panel are each other's inverse")
{
    for (const int zoom : {0, 1, 3, 16})
        for (const Size panel : {Size{128, 64}, Size{800, 480}}) {
            const PictureLayout place{panel, pane, zoom, {7, -9}, 12};
            const PanelSpot spot = place.panel_spot(place.window_spot({12.25, 40.5}));
            CHECK(spot.x == doctest::Approx(12.25));
            CHECK(spot.y == doctest::Approx(40.5));
        }
    const PictureLayout place{{100, 100}, pane, 4};
    CHECK(place.window_spot({0.5, 0.5}).x == 102);
    CHECK(place.panel_spot({100, 0}).y == 0);
}

TEST_CASE("zooming goes on from what is seen")
{
    CHECK(PictureLayout({100, 100}, pane, 0).next_zoom(true) == 4);
    CHECK(PictureLayout({100, 100}, pane, 0).next_zoom(false) == 2);
    CHECK(PictureLayout({100, 100}, pane, 2).next_zoom(true) == 0); // 3 is as large as fits
    CHECK(PictureLayout({100, 100}, pane, 4).next_zoom(false) == 0);
    CHECK(PictureLayout({100, 100}, pane, 1).next_zoom(false) == 1);
    CHECK(PictureLayout({800, 600}, pane, 0).next_zoom(true) == 1);
    CHECK(PictureLayout({800, 600}, pane, 1).next_zoom(false) == 0);
    CHECK(PictureLayout({8, 8}, pane, 64).next_zoom(true) == 64);
    CHECK(PictureLayout({8, 8}, pane, 1000).scale() == 64);
}

TEST_CASE("what is under the pointer stays there while it zooms")
{
    const PictureLayout before{{100, 100}, pane, 4};
    const WindowSpot pointer{180.5, 120.5};
    const PictureLayout after{{100, 100}, pane, 8, before.pan_for(8, pointer)};
    CHECK(after.panel_spot(pointer).x == doctest::Approx(before.panel_spot(pointer).x).epsilon(0.01));
    CHECK(after.panel_spot(pointer).y == doctest::Approx(before.panel_spot(pointer).y).epsilon(0.01));
}

}
