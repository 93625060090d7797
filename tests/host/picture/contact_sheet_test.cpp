#include "host/picture/contact_sheet.hpp"

#include "host/picture/picture.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a contact sheet has about as many rows as columns")
{
    const auto layout = contact_layout(3, {60, 40}, 11);
    REQUIRE(layout);
    CHECK(layout->columns == 2);
    CHECK(layout->cell == Size{66, 51}); // as wide as its label
    CHECK(layout->sheet() == Size{144, 114});
}

TEST_CASE("a contact sheet has fewer rows or columns where a side would be too long")
{
    const auto of_towers = contact_layout(25, {100, 4000}, 8);
    REQUIRE(of_towers);
    CHECK(of_towers->columns == 7); // of 4 rows
    const auto of_beams = contact_layout(25, {4000, 100}, 8);
    REQUIRE(of_beams);
    CHECK(of_beams->columns == 4);
    CHECK(of_beams->sheet().width <= longest_picture_side);
}

TEST_CASE("a contact sheet that has no room is none")
{
    CHECK_FALSE(contact_layout(1687, {240, 240}, 15));
    CHECK(contact_layout(1687, {80, 80}, 15));
    CHECK_FALSE(contact_layout(2, {10, longest_picture_side}, 1));
    CHECK(contact_layout(3, {300, 200}, 11, 1));
    CHECK_FALSE(contact_layout(3, {300, 200}, 11, 16));
    CHECK_FALSE(contact_layout(std::size_t{1} << 40, {1, 1}, 1));
}

}
