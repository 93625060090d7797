#include "core/scene/kfb_limits.hpp"
#include "core/scene_walk.hpp"
#include "tests/core/acceptance.hpp"
#include "tests/core/moved_scene.hpp"
#include "tests/core/raw_drawing.hpp"

#include <algorithm>
#include <cstddef>
#include <doctest/doctest.h>
#include <vector>

/// How much a scene may have.
namespace kfast::test {
namespace {

/// Groups in groups, `depth` of them, around `items`. Made backwards: to copy what is inside of each of
/// thousands takes seconds.
Bytes nested(int depth, Bytes items)
{
    std::ranges::reverse(items);
    for (; depth > 0; --depth) {
        const Bytes head = joined({bytes({1}), varint(static_cast<std::uint32_t>(items.size()))});
        items.insert(items.end(), head.rbegin(), head.rend());
    }
    std::ranges::reverse(items);
    return items;
}

/// `symbols` symbols, each of which uses the one before it inside of `groups` groups; the last is used. Uses
/// and groups lie (groups + 1) * symbols deep in each other.
RawScene chain(int symbols, int groups)
{
    RawScene scene;
    scene.add_symbol(nested(groups, triangle()));
    for (int number = 1; number < symbols; ++number)
        scene.add_symbol(nested(groups, use(number - 1)));
    scene.items = use(symbols - 1);
    return scene;
}

/// 2^7 (count + 2) - 1 items: eight symbols, each with two uses of the one before, the first with `count`
/// objects.
RawScene doubled(std::size_t count)
{
    RawScene scene;
    scene.add_symbol(repeated(nothing(), count));
    for (int number = 1; number < 8; ++number)
        scene.add_symbol(repeated(use(number - 1), 2));
    scene.items = use(7);
    return scene;
}

}

TEST_CASE("groups lie at most 8 deep in each other")
{
    CHECK(takes_items(nested(8, triangle())));
    CHECK_FALSE(takes_items(nested(9, triangle())));
    CHECK_FALSE(takes_items(nested(9, {})));
    CHECK_FALSE(takes_items(nested(10'000, {})));
}

TEST_CASE("groups and uses of symbols lie at most 8 deep in each other")
{
    CHECK(is_accepted(chain(8, 0)));
    CHECK_FALSE(is_accepted(chain(9, 0)));
    CHECK_FALSE(is_accepted(chain(255, 0)));
    CHECK(is_accepted(chain(4, 1)));
    CHECK(is_accepted(chain(2, 3)));
    CHECK_FALSE(is_accepted(chain(2, 4)));
    CHECK_FALSE(is_accepted(chain(3, 2)));
}

TEST_CASE("few symbols and up to 255 are checked alike")
{
    for (const int count : {1, 12, 13, 255}) {
        const auto takes = [count](int depth) {
            RawScene scene;
            for (int number = 1; number < count; ++number)
                scene.add_symbol(triangle());
            scene.add_symbol(nested(depth, triangle()));
            scene.items = use(count - 1);
            return is_accepted(scene);
        };
        CHECK(takes(7));
        CHECK_FALSE(takes(8));
    }
}

TEST_CASE("levels are those of what lies in each other, with the scene and a leaf")
{
    const auto levels_of = [](const RawScene& scene) {
        const Bytes file = scene.file();
        const auto view = SceneView::parse(file);
        REQUIRE(view);
        MovedScene moved{*view}; // in memory of just as many bytes
        const SceneOnPanel shown = moved.on_panel_at({});
        SceneWalk walk{shown, SceneWalk::Opacity::of_leaves};
        std::size_t depth = 0;
        while (walk.next() == SceneWalk::Step::leaf)
            depth = std::max(depth, walk.depth());
        CHECK(view->records().levels >= depth + 1);
        return view->records().levels;
    };
    RawScene scene;
    scene.items = {};
    CHECK(levels_of(scene) == 2);
    scene.items = nested(8, triangle());
    CHECK(levels_of(scene) == 10);
    CHECK(levels_of(chain(8, 0)) == 10);
    CHECK(levels_of(chain(2, 3)) == 10);
}

TEST_CASE("a symbol that is not used may not be too deep by itself either")
{
    RawScene scene;
    scene.add_symbol(nested(7, triangle()));
    CHECK(is_accepted(scene));
    scene.add_symbol(nested(8, triangle())); // with its use, nine
    CHECK_FALSE(is_accepted(scene));
}

TEST_CASE("items, symbols and the scene are at most 65535 as they are stored, and so are tracks")
{
    const auto takes_unused = [](const Bytes& items) {
        RawScene scene;
        scene.add_symbol(items);
        return is_accepted(scene);
    };
    CHECK(takes_unused(repeated(nothing(), 65532)));
    CHECK_FALSE(takes_unused(repeated(nothing(), 65533)));
    RawScene scene;
    scene.add_symbol(repeated(group({}), 65531));
    scene.add_symbol({});
    CHECK(is_accepted(scene));
    scene.add_symbol({});
    CHECK_FALSE(is_accepted(scene));
    const Bytes moved = tracked(2, joined({fixed_track(Property::x, 1), fixed_track(Property::y, 1)}));
    CHECK(takes_unused(repeated(moved, 21844))); // and two of the triangle that is seen
    CHECK_FALSE(takes_unused(joined({repeated(moved, 21844), repeated(nothing(), 3)})));
}

TEST_CASE("the whole scene has at most 65535 items, each counted wherever it is painted")
{
    RawScene scene = doubled(510);
    const auto error_of = [](const RawScene& of) {
        const Bytes file = of.file();
        return SceneView::parse(file).error();
    };
    CHECK(error_of(scene) == Error::too_slow); // nothing is wrong with it but that
    scene.items = joined({nothing(), scene.items});
    CHECK(error_of(scene) == Error::bad_scene);
    SUBCASE("and is refused before 255^8 of them are counted")
    {
        RawScene hostile;
        hostile.add_symbol(nothing());
        for (int number = 1; number < 8; ++number)
            hostile.add_symbol(repeated(use(number - 1), 255));
        hostile.items = repeated(use(7), 255);
        CHECK_FALSE(is_accepted(hostile));
    }
}

TEST_CASE("items beside each other are at most 256 if one of them has an order")
{
    const Bytes ordered = joined({bytes({0x05, 1}), fixed_track(Property::order, 1), block({})});
    CHECK(takes_items(joined({repeated(nothing(), 255), ordered})));
    CHECK_FALSE(takes_items(joined({repeated(nothing(), 256), ordered})));
    CHECK_FALSE(takes_items(group(joined({ordered, repeated(nothing(), 256)}))));
    CHECK(takes_items(joined({ordered, repeated(nothing(), 200), group(repeated(nothing(), 200))})));
    CHECK(takes_items(repeated(nothing(), 400)));
}

TEST_CASE("there is an end to the drawings of keys that are read, one like that before aside")
{
    // 127 points on one stroke: 126 lines of one bit each way, which do not move. It is stored twice, where
    // the one makes the other forgotten.
    const Bytes line = joined({bytes({1, 0, 0, 0, 1, 0xFC, 0x01}), Bytes(32)});
    const auto takes_keys_of = [&line](std::size_t count, bool are_different) {
        RawScene scene;
        scene.drawings = joined({line, Bytes(66 - line.size()), line});
        std::vector<RawKey> keys(count);
        for (std::size_t i = 0; i < count; ++i)
            keys[i] = {.time = {static_cast<std::int32_t>(i)},
                       .drawing = are_different && i % 2 != 0 ? 66U : 0};
        scene.items = joined({bytes({0x08, 1}), key_bytes(keys)});
        return is_accepted(scene);
    };
    CHECK(takes_keys_of(2'040, true)); // 2040 * 128 = 261120
    CHECK_FALSE(takes_keys_of(2'100, true));
    CHECK(takes_keys_of(20'000, false));
}

}
