#include "core/scene/check/picture_cost.hpp"

#include "core/scene/check/scene_check.hpp"
#include "tests/core/raw_scene.hpp"

#include <doctest/doctest.h>

#include <bit>

namespace kfast::test {
namespace {

constexpr std::uint32_t every_part = SceneParts::all;

/// Why parse() refuses it; the number of the item with it.
struct Refused {
    std::optional<Error> error;
    std::uint32_t item = 0;
};

Refused refused(const RawScene& scene)
{
    Refused refused;
    const Bytes file = scene.file();
    if (const auto view = SceneView::parse(file, every_feature, &refused.item); !view)
        refused.error = view.error();
    return refused;
}

bool is_too_slow(const RawScene& scene) { return refused(scene).error == Error::too_slow; }

/// A symbol of that many triangles.
void add_triangles(RawScene& scene, std::size_t count) { scene.add_symbol(repeated(triangle(), count)); }

/// A use of the symbol 0 with a track.
Bytes use_with(const Bytes& track) { return joined({bytes({0x06, 1}), track, bytes({0})}); }

bool exceeds(const ItemTotals& totals) { return totals.is_too_much; }

Time frames(int count) { return Time{count * Time::ticks_per_frame}; }

}

TEST_CASE("a scene has between 17 and 32 parts, or one for each tick")
{
    for (const std::int32_t ticks : {1024, 10'240, 31 * 1024, 32 * 1024, 1'000'000 * 1024}) {
        const SceneParts parts{Time{ticks}};
        const std::uint32_t whole = parts.between({}, Time{ticks + 1});
        CHECK(std::popcount(whole) >= 17);
        CHECK((whole & (whole + 1)) == 0);
        CHECK(parts.between(Time{ticks}, Time{ticks + 1}) == whole - (whole >> 1));
        CHECK(parts.between({}, Time{1}) == 1);
        CHECK(parts.between(Time{5}, Time{5}) == 0);
        CHECK(parts.between(Time{ticks + 1}, Time{ticks + 9}) == 0);
    }
    const SceneParts parts{frames(32)}; // each of two frames, the last moment one by itself
    CHECK(parts.between(frames(2), frames(4)) == 1U << 1);
    CHECK(parts.between(frames(1), Time{frames(4).ticks + 1}) == 7U);
    CHECK(parts.between(frames(32), frames(40)) == 1U << 16);
}

TEST_CASE("costs are added up where they may meet, and end at a second")
{
    PictureCost cost;
    cost.add(100, 1);
    cost.add(70, 2);
    CHECK(cost.largest() == 100);
    cost.add(50, 6);
    CHECK(cost.largest() == 120);
    cost.add(1000, every_part);
    CHECK(cost.largest() == 1120);
    cost.add(0xFFFF'FFFF, 2);
    CHECK(cost.largest() == PictureCost::max);
    cost.add(0xFFFF'FFFF, every_part);
    cost.add(0xFFFF'FFFF, every_part);
    CHECK(cost.largest() == PictureCost::max);
    CHECK(cost_of_leaf({.is_filled = true, .is_stroked = true}, 0xFFFF'FFFF, 1024) >= PictureCost::max);
    CHECK(cost_of_path(kfb::max_drawing_points) > 4'000);
    CHECK(cost_of_ordered(0xFFFF'FFFF, 0xFFFF'FFFF) ==
          cost_of_ordered(kfb::max_ordered_items, kfb::max_ordered_items));
    CHECK(cost_of_records({}, 0xFFFF'FFFF, 0) >= PictureCost::max);
}

TEST_CASE("a scene whose pictures take longer than a second is refused, and the item told that takes most")
{
    RawScene scene;
    add_triangles(scene, 200);
    scene.items = repeated(use(0), 60);
    CHECK_FALSE(refused(scene).error);
    scene.items = joined({repeated(use(0), 60), group(joined({nothing(), use(0)})), repeated(use(0), 60)});
    scene.symbols = joined({scene.symbols, block(repeated(use(0), 2))});
    ++scene.symbol_count;
    scene.items = joined({scene.items, use(1)});
    CHECK(refused(scene).error == Error::too_slow);
    CHECK(refused(scene).item == 200 + 2 + 60 + 3 + 60);
    scene.items.resize(scene.items.size() - 2);
    CHECK(refused(scene).item == 200 + 2); // the first of equals
}

TEST_CASE("what is never seen together is not added up")
{
    RawScene scene;
    scene.drawings = joined({bytes({1, 0, 0, 0, 1, 0xFC, 0x0F}), Bytes(256)}); // 1023 points
    scene.add_symbol(repeated(triangle(), 30)); // some 15,000 thousands of instructions
    const auto shown = [](int from, int to, std::int32_t value, Property property) {
        return use_with(moving_track(property, {{{}, 0, 0}, {frames(from), 0, value}, {frames(to), 0, 0}}));
    };
    const auto scene_of = [&](std::int32_t value, Property property) {
        scene.items.clear();
        for (int frame = 1; frame < 9; ++frame)
            scene.items = joined({scene.items, repeated(shown(frame, frame + 1, value, property), 2)});
        return scene;
    };
    CHECK_FALSE(is_too_slow(scene_of(1, Property::visible)));
    CHECK(is_too_slow(scene_of(255, Property::opacity))); // each fades in all the way from 0
    scene.law_count = 1;
    scene.laws = bytes({0xF4}); // hold
    const auto at_once = [&](int from) {
        return use_with(
            moving_track(Property::opacity, {{{}, 1, 0}, {frames(from), 1, 255}, {frames(from + 1), 1, 0}}));
    };
    scene.items.clear();
    for (int frame = 1; frame < 9; ++frame)
        scene.items = joined({scene.items, repeated(at_once(frame), 2)});
    CHECK_FALSE(is_too_slow(scene));
    scene.items = repeated(use_with(fixed_track(Property::visible, 0)), 500);
    CHECK_FALSE(is_too_slow(scene));
    // Within a group, and within a symbol, too.
    scene.items = group(scene_of(1, Property::visible).items);
    CHECK_FALSE(is_too_slow(scene));
    scene.add_symbol(scene_of(1, Property::visible).items);
    scene.items = use(1);
    CHECK_FALSE(is_too_slow(scene));
    scene.items = repeated(use(1), 3);
    CHECK(is_too_slow(scene));
    // Nor what symbols show at different times.
    scene.symbols = block(repeated(triangle(), 30));
    scene.symbol_count = 1;
    scene.items.clear();
    for (int frame = 1; frame < 9; ++frame) {
        scene.add_symbol(repeated(shown(frame, frame + 1, 1, Property::visible), 2));
        scene.items = joined({scene.items, use(frame)});
    }
    CHECK_FALSE(is_too_slow(scene));
}

TEST_CASE("the item told is one that is seen")
{
    RawScene scene;
    scene.add_symbol(repeated(triangle(), 3'000));
    scene.add_symbol(repeated(triangle(), 9'000));
    scene.items = joined({use_with(fixed_track(Property::visible, 0)), repeated(use(0), 5), bytes({0x06, 1}),
                          fixed_track(Property::visible, 0), bytes({1}), use(0)});
    CHECK(refused(scene).error == Error::too_slow);
    CHECK(refused(scene).item == 12'000 + 1);
}

TEST_CASE("what an input shows may be seen at any time")
{
    RawScene scene;
    add_triangles(scene, 200);
    scene.input_count = 1;
    scene.inputs = input_bytes("i");
    const auto by = [&](Driver driver) {
        return joined({bytes({static_cast<int>(Property::visible)}),
                       track_keys({{{}, 0, 0}, {Time{1024}, 0, 1}, {Time{2048}, 0, 0}}, 0, driver)});
    };
    scene.items = joined({repeated(use_with(by({})), 60), repeated(use_with(by({1})), 60)});
    CHECK(is_too_slow(scene));
    scene.items = joined({repeated(use_with(by({})), 60), use_with(by({1}))});
    CHECK_FALSE(is_too_slow(scene));
}

TEST_CASE("groups, tracks, borders and orders cost something, too")
{
    RawScene scene;
    scene.add_symbol(repeated(group({}), 255));
    scene.items = repeated(use(0), 250);
    CHECK_FALSE(is_too_slow(scene));
    Bytes moved = bytes({0x05, 8});
    for (const Property property :
         {Property::x, Property::y, Property::z, Property::rotation, Property::scale_x, Property::scale_y,
          Property::pivot_x, Property::pivot_y})
        moved = joined({moved, fixed_track(property, 5)});
    scene.add_symbol(repeated(joined({moved, bytes({0})}), 255));
    scene.items = repeated(use(1), 250);
    CHECK(is_too_slow(scene));
    RawScene bordered;
    bordered.borders = kfb::max_borders;
    CHECK_FALSE(is_too_slow(bordered));
    bordered.items = repeated(triangle(), 5'000);
    CHECK(is_too_slow(bordered));
    RawScene ordered;
    const Bytes first = joined({bytes({0x05, 1}), fixed_track(Property::order, 1), bytes({0})});
    ordered.add_symbol(joined({first, repeated(group({}), 255)}));
    ordered.add_symbol(repeated(first, 256));
    ordered.items = repeated(use(0), 40); // each list is gone through twice
    CHECK_FALSE(is_too_slow(ordered));
    ordered.items = repeated(use(1), 40); // 257 times
    CHECK(is_too_slow(ordered));
}

TEST_CASE("items, their layers and how deep they lie have limits, and what exceeds one stays too much")
{
    const auto of = [](std::uint32_t items, std::uint32_t steps) {
        ItemTotals totals;
        totals.items = static_cast<std::uint16_t>(items);
        totals.paint_steps = static_cast<std::uint16_t>(steps);
        return totals;
    };
    CHECK_FALSE(exceeds(of(kfb::max_items - 1, 0).in_item()));
    CHECK(exceeds(of(kfb::max_items, 0).in_item()));
    ItemTotals deep = of(1, 1);
    for (std::uint32_t depth = 0; depth < kfb::max_depth; ++depth)
        deep = deep.in_item();
    CHECK_FALSE(exceeds(deep));
    CHECK(exceeds(deep.in_item()));
    CHECK(exceeds(deep.in_item().in_item()));

    const auto blended = [&of](std::uint32_t steps) {
        ItemTotals totals = of(1, steps);
        totals.blend();
        return totals;
    };
    CHECK_FALSE(exceeds(blended(kfb::max_paint_steps - 2)));
    ItemTotals full = blended(kfb::max_paint_steps - 1);
    CHECK(exceeds(full));
    full.blend(); // whose sum has wrapped around
    CHECK(exceeds(full));

    const auto sum = [](ItemTotals totals, const ItemTotals& item) {
        totals.add(item);
        return totals;
    };
    CHECK_FALSE(exceeds(sum(of(kfb::max_items - 1, 0), of(1, 0))));
    CHECK(exceeds(sum(of(kfb::max_items, 0), of(1, 0))));
    CHECK_FALSE(exceeds(sum(of(1, kfb::max_paint_steps - 2), of(1, 2))));
    CHECK(exceeds(sum(of(1, kfb::max_paint_steps - 1), of(1, 2))));
    CHECK(exceeds(sum(of(1, 1), full)));
    CHECK(exceeds(sum(full, of(1, 1))));
}

TEST_CASE("keys that many tracks share are read for each: there is an end to it")
{
    const auto scene_with = [](int keys, std::initializer_list<Property> properties) {
        KeyTimes key_times;
        for (int i = 0; i < keys; ++i)
            key_times.push_back({Time{i}, 0});
        RawScene scene;
        scene.ticks = 100 * 1024;
        Bytes tracks;
        for (const Property property : properties)
            tracks = joined({tracks, bytes({static_cast<int>(property)}),
                             tracks.empty() ? key_time_bytes(key_times) : bytes({0}), bytes({0, 0})});
        scene.items = joined({bytes({0x05, static_cast<int>(properties.size())}), tracks, bytes({0})});
        return scene;
    };
    CHECK_FALSE(
        refused(scene_with(60'000, {Property::x, Property::y, Property::rotation, Property::opacity})).error);
    CHECK(refused(scene_with(60'000, {Property::x, Property::y, Property::z, Property::rotation,
                                      Property::pivot_x, Property::opacity}))
              .error == Error::bad_scene);
    RawScene late = scene_with(60'000, {Property::x, Property::y, Property::z, Property::rotation,
                                        Property::pivot_x, Property::opacity});
    late.items = joined({repeated(triangle(), 5), late.items});
    CHECK(refused(late).item == 5);
}

TEST_CASE("an allowance is a share of the scene's size and some more")
{
    ReadAllowance allowance{1'000};
    CHECK_FALSE(allowance.take((1 << 18) + 2'001));
    CHECK(allowance.take((1 << 18) + 2'000));
    CHECK(allowance.take(0));
    CHECK_FALSE(allowance.take(1));
}

}
