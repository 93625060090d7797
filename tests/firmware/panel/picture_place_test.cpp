#include "firmware/panel/picture_place.hpp"

#include <doctest/doctest.h>

#include <array>

namespace kfast::test {
namespace {

constexpr std::array rotations{Rotation::none, Rotation::quarter, Rotation::half, Rotation::three_quarters};

/// In the order of Rotation.
std::array<PicturePlace, 4> places(PanelSettings settings, Size memory)
{
    std::array<PicturePlace, 4> result;
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        settings.rotation = rotations[i];
        result[i] = picture_place(settings, memory);
    }
    return result;
}

}

TEST_CASE("a glass that fills the memory begins at its corner however it is turned")
{
    CHECK(places({.glass = {240, 320}}, {240, 320}) == std::array<PicturePlace, 4>{});
}

TEST_CASE("a square glass at the upper end of a higher memory begins at 80 once that end is the lower one")
{
    CHECK(places({.glass = {240, 240}}, {240, 320}) ==
          std::array<PicturePlace, 4>{{{0, 0}, {0, 0}, {0, 80}, {80, 0}}});
}

TEST_CASE(
    "a glass that is a column off the middle has that column on the other side when it is turned by half")
{
    CHECK(places({.glass = {135, 240}, .column = 52, .row = 40}, {240, 320}) ==
          std::array<PicturePlace, 4>{{{52, 40}, {40, 53}, {53, 40}, {40, 52}}});
}

TEST_CASE("of a memory that is scanned no further than the glass, nothing lies below the glass")
{
    PanelSettings settings{.glass = {72, 40}, .column = 30, .row = 8};
    CHECK(scanned(settings, {128, 64}) == Size{128, 48});
    CHECK(picture_place(settings, scanned(settings, {128, 64})) == PicturePlace{30, 8});
    settings.rotation = Rotation::half;
    CHECK(picture_place(settings, scanned(settings, {128, 64})) == PicturePlace{26, 0});
}

TEST_CASE("every pixel of a turned picture lies where the glass has it")
{
    const PanelSettings glass{.glass = {3, 4}, .column = 2, .row = 1};
    const Size memory{8, 6};
    for (const Rotation rotation : rotations) {
        PanelSettings settings = glass;
        settings.rotation = rotation;
        const PicturePlace place = picture_place(settings, memory);
        for (int y = 0; y < settings.size().height; ++y) {
            for (int x = 0; x < settings.size().width; ++x) {
                const int column = place.column + x;
                const int row = place.row + y;
                // What the controller makes of an address, and what the meaning of the rotation is.
                const std::array<PicturePlace, 4> in_memory{
                    {{column, row}, {7 - row, column}, {7 - column, 5 - row}, {row, 5 - column}}};
                const std::array<PicturePlace, 4> on_glass{{{x, y}, {2 - y, x}, {2 - x, 3 - y}, {y, 3 - x}}};
                const auto turned = static_cast<std::size_t>(rotation);
                CHECK(in_memory[turned] ==
                      PicturePlace{2 + on_glass[turned].column, 1 + on_glass[turned].row});
            }
        }
    }
}

}
