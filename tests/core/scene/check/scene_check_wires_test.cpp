#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/core/acceptance.hpp"
#include "tests/core/raw_drawing.hpp"

#include <doctest/doctest.h>

/// Objects that are wire frames.
namespace kfast::test {
namespace {

scene::Drawing flat() { return {{polyline_of({{0, 0}, {160, 0}, {160, 160}}), polyline_of({{16, 16}})}}; }
scene::Drawing depths() { return {{polyline_of({{0, 0}, {32, 0}, {-32, 0}}), polyline_of({{99, 0}})}}; }

/// A stroked wire frame of one key.
Bytes wires(std::uint32_t drawing, std::uint32_t depths, int more_bits = 0)
{
    return joined({bytes({0x13 | more_bits, 2}), bytes({1, 16, 0, 32}),
                   key_bytes({{.drawing = drawing, .more = static_cast<std::int32_t>(depths)}})});
}

bool takes(const scene::Drawing& drawing, const scene::Drawing& depths)
{
    RawDrawings drawings;
    const std::uint32_t at = drawings.add(drawing);
    RawScene scene;
    scene.items = wires(at, drawings.add(depths));
    scene.drawings = drawings.bytes();
    return is_accepted(scene);
}

}

TEST_CASE("depths are built as their drawing is")
{
    CHECK(takes(flat(), depths()));
    CHECK(takes({}, {}));
    CHECK_FALSE(takes(flat(), {}));
    CHECK_FALSE(takes({}, depths()));
    scene::Drawing fewer_segments = depths();
    fewer_segments.strokes[0].segments.pop_back();
    CHECK_FALSE(takes(flat(), fewer_segments));
    scene::Drawing fewer_strokes = depths();
    fewer_strokes.strokes.pop_back();
    CHECK_FALSE(takes(flat(), fewer_strokes));
}

TEST_CASE("wires are straight")
{
    scene::Drawing curved = flat();
    curved.strokes[0].segments[0].cubic = true;
    scene::Drawing curved_depths = depths();
    curved_depths.strokes[0].segments[0].cubic = true;
    CHECK_FALSE(takes(curved, curved_depths));
    CHECK_FALSE(takes(flat(), curved_depths));
    CHECK_FALSE(takes(curved, depths()));
}

TEST_CASE("wires have no fill, no arrival drawings and no carrier")
{
    RawDrawings drawings;
    const std::uint32_t drawing = drawings.add(flat());
    const std::uint32_t depth = drawings.add(depths());
    RawScene scene;
    scene.drawings = drawings.bytes();
    scene.items = wires(drawing, depth);
    CHECK(is_accepted(scene));
    for (const int bit : {5, 6, 7}) {
        scene.items = wires(drawing, depth, 1 << bit);
        CHECK(is_accepted(scene) == (bit == 5)); // the rule of a fill, as of other objects that have none
    }
    scene.items = joined({bytes({0x1B, 2}), bytes({1, 1, 16, 0, 32}),
                          key_bytes({{.drawing = drawing, .more = static_cast<std::int32_t>(depth)}})});
    CHECK_FALSE(is_accepted(scene));
    scene.items = wires(drawing, depth);
    scene.items[1] = std::byte{3};
    CHECK_FALSE(is_accepted(scene));
}

TEST_CASE("depths lie among the drawings, and are sound themselves")
{
    RawDrawings drawings;
    const std::uint32_t drawing = drawings.add(flat());
    const std::uint32_t depth = drawings.add(depths());
    RawScene scene;
    scene.drawings = drawings.bytes();
    const auto end = static_cast<std::uint32_t>(scene.drawings.size());
    for (const std::uint32_t offset : {end, end + 100, 0xFFFFFFFFU}) {
        scene.items = wires(drawing, offset);
        CHECK_FALSE(is_accepted(scene));
    }
    scene.drawings.pop_back();
    scene.items = wires(drawing, depth);
    CHECK_FALSE(is_accepted(scene));
}

TEST_CASE("there is an end to the depths that are read")
{
    // 1023 points on a stroke that does not move
    const Bytes row = joined({bytes({1, 0, 0, 0, 1, 0xFC, 0x0F}), Bytes(256)});
    const auto takes_keys = [&row](std::size_t count) {
        std::vector<RawKey> keys(count);
        for (std::size_t i = 0; i < count; ++i)
            keys[i] = {.time = {static_cast<std::int32_t>(i)}, .more = i % 2 == 0 ? 0 : 297};
        RawScene scene;
        scene.drawings =
            joined({row, Bytes(297 - row.size()), row}); // where the one makes the other forgotten
        scene.items = joined({bytes({0x13, 2}), bytes({1, 16, 0, 32}), key_bytes(keys)});
        return is_accepted(scene);
    };
    CHECK(takes_keys(125)); // 125 * (1 + 1024 + 1023) = 256000
    CHECK_FALSE(takes_keys(140));
}

}
