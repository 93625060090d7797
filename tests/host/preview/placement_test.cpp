#include "host/preview/painter/scaled_picture.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a picture is magnified by a whole number and centred")
{
    CHECK(placement({100, 50}, {100, 50}) == Rect{0, 0, 100, 50});
    CHECK(placement({100, 50}, {299, 199}) == Rect{49, 49, 200, 100});
    CHECK(placement({100, 50}, {400, 151}) == Rect{50, 0, 300, 150});
}

TEST_CASE("a picture that does not fit is shrunk whole")
{
    CHECK(placement({200, 100}, {100, 100}) == Rect{0, 25, 100, 50});
    CHECK(placement({100, 200}, {100, 100}) == Rect{25, 0, 50, 100});
    CHECK(placement({4096, 1}, {64, 64}) == Rect{0, 31, 64, 1});
    CHECK(placement({4096, 4096}, {1, 1}) == Rect{0, 0, 1, 1});
}

}
