#include "host/beam/light_sheet.hpp"

#include <cmath>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr Size side{101, 101};

double sum(const LightSheet& sheet, std::size_t channel = 0)
{
    double all = 0;
    for (int i = 0; i < sheet.size().width * sheet.size().height; ++i)
        all += double{sheet.at(static_cast<std::size_t>(i))[channel]};
    return all;
}

double at(const LightSheet& sheet, int x, int y)
{
    return sheet.at(static_cast<std::size_t>(y * sheet.size().width + x))[0];
}

}

TEST_CASE("all light of a line is on the sheet, however long it is and however wide its spot")
{
    for (const double length : {0.0, 0.3, 7.7, 40.0})
        for (const double deviation : {0.4, 1.2, 2.5}) {
            LightSheet sheet{side, 2};
            sheet.add_line({30.2, 50.7}, {30.2 + length, 50.7 - length / 2}, {3, 0.5F});
            CHECK(sum(sheet) == doctest::Approx(3).epsilon(1e-4));
            sheet.spread(deviation);
            CAPTURE(length);
            CAPTURE(deviation);
            CHECK(sum(sheet) == doctest::Approx(3).epsilon(2e-3));
            CHECK(sum(sheet, 1) == doctest::Approx(0.5).epsilon(2e-3));
        }
}

TEST_CASE("light falls in even shares along its line")
{
    LightSheet sheet{side, 1};
    sheet.add_line({10, 50}, {90, 50}, {80});
    for (int x = 12; x < 88; ++x)
        CHECK(at(sheet, x, 50) == doctest::Approx(1).epsilon(1e-3));
    CHECK(at(sheet, 50, 49) == 0);
    CHECK(at(sheet, 5, 50) == 0);
}

TEST_CASE("a spot is as wide as its deviation says, the same in all directions")
{
    for (const double deviation : {1.0, 2.0, 3.0}) {
        LightSheet sheet{side, 1};
        sheet.add_line({50, 50}, {50, 50}, {1});
        sheet.spread(deviation);
        const int reach = static_cast<int>(2 * deviation);
        const double expected = std::exp(-0.5 * reach * reach / (deviation * deviation));
        CAPTURE(deviation);
        CHECK(at(sheet, 50 + reach, 50) / at(sheet, 50, 50) == doctest::Approx(expected).epsilon(0.03));
        CHECK(at(sheet, 50 + reach, 50) == doctest::Approx(at(sheet, 50, 50 - reach)));
        CHECK(at(sheet, 50 - reach, 50) == doctest::Approx(at(sheet, 50 + reach, 50)));
        CHECK(at(sheet, 50 + static_cast<int>(6 * deviation), 50) > 0); // the halo
    }
}

TEST_CASE("a place between pixels is the middle of its light")
{
    LightSheet sheet{side, 1};
    sheet.add_line({40.25, 60.75}, {40.25, 60.75}, {1});
    CHECK(at(sheet, 40, 60) == doctest::Approx(0.75 * 0.25));
    CHECK(at(sheet, 41, 61) == doctest::Approx(0.25 * 0.75));
}

TEST_CASE("light beyond the edges is lost, and nothing else")
{
    for (const Size size : {Size{1, 1}, Size{3, 40}, Size{40, 3}}) {
        LightSheet sheet{size, 3};
        sheet.add_line({-100, -100}, {100, 100}, {1, 1, 1});
        sheet.add_line({-1e9, 5}, {-1e9, 5}, {1, 1, 1});
        sheet.spread(2);
        CHECK(sum(sheet) > 0);
        CHECK(sum(sheet) < 1);
        sheet.clear();
        CHECK(sum(sheet) == 0);
    }
}

}
