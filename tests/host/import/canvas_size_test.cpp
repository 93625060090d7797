#include "host/import/extent.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using importing::fit_canvas;
using importing::share_within_reach;

namespace {

art::Document of_size(double width, double height)
{
    art::Document document;
    document.width = width;
    document.height = height;
    return document;
}

}

TEST_CASE("a canvas that a scene can have stays as it is, in whole pixels")
{
    art::Losses losses;
    for (const double side : {1.0, 24.0, 2047.0}) {
        art::Document document = of_size(side, side);
        fit_canvas(document, std::nullopt, 1, losses);
        CHECK(document.width == side);
    }
    art::Document document = of_size(793.7, 0.2);
    fit_canvas(document, std::nullopt, 1, losses);
    CHECK(document.width == 794);
    CHECK(document.height == 1);
    CHECK(losses.empty());
}

TEST_CASE("a canvas that is too large is told")
{
    art::Losses losses;
    art::Document document = of_size(4094, 1000);
    fit_canvas(document, std::nullopt, 1, losses);
    CHECK(document.width == 2047);
    CHECK(document.height == 500);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].feature == "canvas of 4094x1000 pixels");
    CHECK(losses.list()[0].instead == "all of it smaller, on 2047x500");
}

TEST_CASE("a size that is asked for is no loss")
{
    art::Losses losses;
    art::Document wide = of_size(400, 100);
    fit_canvas(wide, Size{240, 240}, 1, losses);
    CHECK(wide.width == 240);
    CHECK(wide.height == 60);
    art::Document icon = of_size(24, 24);
    fit_canvas(icon, Size{240, 135}, 1, losses);
    CHECK(icon.width == 135);
    CHECK(icon.height == 135);
    CHECK(losses.empty());
}

TEST_CASE("art becomes smaller still for what lies beyond its canvas, and that is told")
{
    art::Losses losses;
    art::Document document = of_size(1000, 4094);
    fit_canvas(document, std::nullopt, 0.5, losses);
    CHECK(document.width == 250);
    CHECK(document.height == 1024);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].instead == "all of it smaller, on 250x1024");
}

TEST_CASE("how much smaller art becomes for its coordinates")
{
    const art::Document tall = of_size(1151, 2047);
    const scene_text::Reach far{.left_alone = 4080, .in_groups = 2000};
    CHECK(share_within_reach(tall, far, true) == doctest::Approx(0.4995));
    CHECK(share_within_reach(tall, far, false) == 1);
    CHECK(share_within_reach(tall, {.left_alone = 8160, .in_groups = 4080}, false) ==
          doctest::Approx(0.4995));
    CHECK(share_within_reach(tall, {.left_alone = 100, .in_groups = 100}, true) == 1);
    CHECK(share_within_reach(tall, {.left_alone = 4000, .in_groups = 2047}, false) == 1);
    CHECK(share_within_reach(of_size(961, 100), far, true) == doctest::Approx(0.4995));
    CHECK(share_within_reach(of_size(959, 100), far, true) == 1);
}
