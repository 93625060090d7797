#include "host/picture/picture.hpp"

#include "host/program/failure.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr Colour dark{};
constexpr Colour light{255, 255, 255};

Picture dotted(std::initializer_list<Rect> dots)
{
    Picture picture = plain_picture(7, 5, dark, "the picture");
    for (const Rect& dot : dots)
        picture.pixels[static_cast<std::size_t>(dot.y * 7 + dot.x)] = light;
    return picture;
}

TEST_CASE("the part of a picture that has changed is as small as can be")
{
    CHECK_FALSE(changed_part(dotted({}), dotted({})));
    CHECK(changed_part(dotted({}), dotted({{0, 0}})) == Rect{0, 0, 1, 1});
    CHECK(changed_part(dotted({{6, 4}}), dotted({})) == Rect{6, 4, 1, 1});
    CHECK(changed_part(dotted({{3, 1}}), dotted({{1, 3}, {2, 2}})) == Rect{1, 1, 3, 3});
    CHECK(changed_part(dotted({{5, 1}}), dotted({{5, 1}, {2, 2}, {4, 2}})) == Rect{2, 2, 3, 1});
}

TEST_CASE("a part is put back where it was")
{
    const Picture before = dotted({{1, 1}});
    const Picture after = dotted({{2, 3}, {4, 2}});
    const Rect area = *changed_part(before, after);
    Picture mended = before;
    put(part(after, area), mended, area.x, area.y);
    CHECK(mended.pixels == after.pixels);
}

TEST_CASE("pixels become squares")
{
    const Picture large = scaled(dotted({{1, 2}}), 3);
    CHECK(large.size == Size{21, 15});
    for (int y = 0; y < 15; ++y)
        for (int x = 0; x < 21; ++x)
            CHECK((large.at(x, y) == light) == (x / 3 == 1 && y / 3 == 2));
}

TEST_CASE("pictures that are too large are refused")
{
    CHECK_THROWS_AS(scaled(dotted({}), 2341), Failure);                       // 16387 wide
    CHECK_THROWS_AS(plain_picture(16384, 16384, dark, "the sheet"), Failure); // too many in all
}

}
}
