#include "host/import/canvas_size.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using importing::fit_canvas;

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
        fit_canvas(document, std::nullopt, losses);
        CHECK(document.width == side);
    }
    art::Document document = of_size(793.7, 0.2);
    fit_canvas(document, std::nullopt, losses);
    CHECK(document.width == 794);
    CHECK(document.height == 1);
    CHECK(losses.empty());
}

TEST_CASE("a canvas that is too large is told")
{
    art::Losses losses;
    art::Document document = of_size(4094, 1000);
    fit_canvas(document, std::nullopt, losses);
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
    fit_canvas(wide, Size{240, 240}, losses);
    CHECK(wide.width == 240);
    CHECK(wide.height == 60);
    art::Document icon = of_size(24, 24);
    fit_canvas(icon, Size{240, 135}, losses);
    CHECK(icon.width == 135);
    CHECK(icon.height == 135);
    CHECK(losses.empty());
}
