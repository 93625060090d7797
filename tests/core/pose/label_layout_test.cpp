#include "core/pose/label_layout.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/core/raw_label.hpp"

#include <doctest/doctest.h>
#include <vector>

namespace kfast::test {
namespace {

/// Where glyphs begin, in 1/16 px.
std::vector<std::int32_t> beginnings(const RawLabel& raw, std::initializer_list<int> glyphs)
{
    const Bytes bytes = raw.bytes();
    const LabelView label = LabelView::of(ByteReader{bytes});
    const Bytes text = test::bytes(glyphs);
    std::vector<std::int32_t> places;
    for (LabelLayout layout{label, text}; !layout.at_end();) {
        const PlacedGlyph placed = layout.next();
        CHECK(placed.drawing == 100U * std::to_integer<std::uint32_t>(text[places.size()]));
        CHECK(placed.origin.y == Fixed::sixteenths(raw.y));
        CHECK(placed.origin.x.raw() % (Fixed::one / 16) == 0);
        places.push_back(placed.origin.x.raw() / (Fixed::one / 16));
    }
    return places;
}

constexpr std::int32_t sixteenth = kfb::advance_one / 16;

}

TEST_CASE("glyphs follow each other by their advances and the spacing")
{
    RawLabel label;
    label.x = 160;
    label.y = -7;
    label.drawings = {0, 100, 200};
    label.advances = {10 * sixteenth, 20 * sixteenth, 0};
    CHECK(beginnings(label, {}).empty());
    CHECK(beginnings(label, {0, 1, 2, 0}) == std::vector{160, 170, 190, 190});
    label.spacing = -3 * sixteenth;
    CHECK(beginnings(label, {1, 1, 1}) == std::vector{160, 177, 194});
}

TEST_CASE("a text lies beside its place or in the middle of it, without spacing behind the last glyph")
{
    RawLabel label;
    label.drawings = {0, 100};
    label.advances = {10 * sixteenth, 20 * sixteenth};
    label.spacing = 4 * sixteenth;
    label.align = 1;
    CHECK(beginnings(label, {0, 1}) == std::vector{-17, -3});
    CHECK(beginnings(label, {}).empty());
    label.align = 2;
    CHECK(beginnings(label, {0, 1}) == std::vector{-34, -20});
    label.x = 1000;
    CHECK(beginnings(label, {1}) == std::vector{980});
}

TEST_CASE("where a glyph begins is rounded once, halves to the right")
{
    RawLabel label;
    label.drawings = {0};
    label.advances = {sixteenth / 3};
    CHECK(beginnings(label, {0, 0, 0, 0, 0, 0, 0}) == std::vector{0, 0, 1, 1, 1, 2, 2});
    label.advances = {sixteenth / 2};
    CHECK(beginnings(label, {0, 0, 0, 0}) == std::vector{0, 1, 1, 2});
    label.advances = {-sixteenth / 2};
    CHECK(beginnings(label, {0, 0, 0, 0}) == std::vector{0, 0, -1, -1});
    label.advances = {sixteenth};
    label.align = 1;
    CHECK(beginnings(label, {0}) == std::vector{0}); // from -1/2
}

TEST_CASE("pairs are kerned in their order")
{
    RawLabel label;
    label.drawings = {0, 100, 200};
    label.advances = {16 * sixteenth, 16 * sixteenth, 16 * sixteenth};
    label.pairs = {{0, 1, -4 * sixteenth}, {1, 0, 2 * sixteenth}, {2, 2, -sixteenth}};
    CHECK(beginnings(label, {0, 1, 0, 0, 2, 2, 1}) == std::vector{0, 12, 30, 46, 62, 77, 93});
    label.align = 2;
    CHECK(beginnings(label, {0, 1}) == std::vector{-28, -16});
}

}
