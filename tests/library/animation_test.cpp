#include "library/kfast.hpp"

#include "tests/library/screen.hpp"

#include <array>
#include <cstdint>
#include <doctest/doctest.h>
#include <vector>

namespace kfast::test {

TEST_CASE("the C++ animation draws the same")
{
    const Bytes scene = compiled(moving);
    std::vector<std::uint32_t> block(*Animation::block_bytes(scene, {width, height}) / 4 + 1);
    const auto borrowed = std::as_writable_bytes(std::span{block});
    CHECK(Animation::create(scene, {width, height}, borrowed.first(8)).error() == Error::block_too_small);
    CHECK(Animation::create(std::span{scene}.first(20), {width, height}, borrowed).error() ==
          Error::truncated);
    auto animation = Animation::create(scene, {width, height}, borrowed);
    REQUIRE(animation);
    CHECK_FALSE(animation->choose_clip("forth"));
    CHECK(animation->choose_clip("back"));
    animation->show_after(40);
    std::vector<std::byte> buffer(2 * width * height);
    Bytes pixels;
    CHECK_FALSE(
        animation->draw<PixelFormat::rgb565>(std::span{buffer}.first(2 * width - 1), [](Rect, auto) {}));
    CHECK(animation->draw<PixelFormat::rgb565>(buffer, [&](Rect area, std::span<const std::byte> part) {
        CHECK(area == Rect{0, 0, width, height});
        pixels.assign(part.begin(), part.end());
    }));
    CHECK(pixels == picture(moving, Time::frame(5)));
}

TEST_CASE("the C++ animation takes drawings by name")
{
    const Bytes scene =
        compiled("kfast 1\ncanvas 30 20\ninput curve kind=drawing points=3\nobject o stroke=lime live=curve");
    Bytes block(*Animation::block_bytes(scene, {width, height}));
    auto animation = Animation::create(scene, {width, height}, block);
    REQUIRE(animation);
    const std::vector<InputPoint> points{{16, 16}, {160, 32}, {24, 80}};
    const std::array<InputStroke, 2> strokes{points, points};
    CHECK(animation->set_drawing("curve", std::span{strokes}.first(1)));
    CHECK_FALSE(animation->set_drawing("curve", strokes));
    CHECK_FALSE(animation->set_drawing("curse", std::span{strokes}.first(1)));
    CHECK_FALSE(animation->drawing("curse"));
    CHECK(animation->drawing("curve")->stroke(0).size() == 3);
    animation->drawing("curve")->add({1, 2});
    animation->show_next_drawing("curve");
    CHECK(animation->drawing("curve")->stroke(0).size() == 1);
}

TEST_CASE("the C++ animation takes inputs by name")
{
    const Bytes scene = compiled(steered);
    std::vector<std::uint32_t> block(*Animation::block_bytes(scene, {width, height}) / 4 + 1);
    auto animation = Animation::create(scene, {width, height}, std::as_writable_bytes(std::span{block}));
    REQUIRE(animation);
    CHECK_FALSE(animation->set_input("gase", 0));
    CHECK(animation->set_input("open", 50'000));
    CHECK(animation->set_input("gaze", -250));
    animation->show({});
    std::vector<std::byte> buffer(2 * width * height);
    Bytes pixels;
    CHECK(animation->draw<PixelFormat::rgb565>(
        buffer, [&](Rect, std::span<const std::byte> part) { pixels.assign(part.begin(), part.end()); }));
    CHECK(pixels == picture(steered, {24576}, {32768}));
}

}
