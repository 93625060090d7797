#include "core/scene_walk.hpp"

#include "tests/core/moved_scene.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/core/raw_scene.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

/// A triangle filled with the colour that letters_of() writes as `name`, with a track or none.
Bytes letter(char name, const Bytes& track = {})
{
    const Bytes rest = joined({bytes({name - 'a'}), one_key()});
    return track.empty() ? joined({bytes({0x08}), rest}) : joined({bytes({0x0C, 1}), track, rest});
}

Bytes ordered(char name, int order) { return letter(name, fixed_track(Property::order, order)); }

Bytes faded_group(int opacity, const Bytes& items)
{
    return joined({bytes({5, 1}), fixed_track(Property::opacity, opacity), block(items)});
}

Bytes scene_of(const Bytes& items, const std::vector<Bytes>& symbols = {})
{
    RawScene raw;
    raw.palette = repeated(bytes({0, 0, 0, 255}), 26);
    for (const Bytes& symbol : symbols)
        raw.add_symbol(symbol);
    raw.items = items;
    return raw.file();
}

/// All steps of a walk: leaves, and groups that are blended in brackets.
std::string letters_of(const Bytes& file, Time time = {},
                       SceneWalk::Opacity opacity = SceneWalk::Opacity::of_groups)
{
    using Step = SceneWalk::Step;
    const SceneView scene = accepted(file);
    MovedScene moved{scene};
    const SceneOnPanel shown = moved.on_panel_at(time);
    SceneWalk walk{shown, opacity};
    std::string text;
    for (Step step = walk.next(); step != Step::end; step = walk.next()) {
        if (step == Step::leaf)
            text += static_cast<char>('a' + walk.node().style.fill);
        else if (step == Step::begin_group)
            text += '(';
        else
            text += ")" + std::to_string(walk.group_opacity());
    }
    return text;
}

std::string letters_in(const Bytes& items, Time time = {}) { return letters_of(scene_of(items), time); }

}

TEST_CASE("without orders items are painted as they lie")
{
    CHECK(letters_in({}).empty());
    CHECK(letters_in(joined({letter('c'), letter('a'), letter('b')})) == "cab");
    CHECK(letters_in(joined({letter('c', fixed_track(Property::x, -5)), letter('a')})) == "ca");
    CHECK(letters_in(joined({letter('a'), group(joined({letter('b'), group({}), group(letter('c'))})),
                             letter('d')})) == "abcd");
}

TEST_CASE("the lowest order is painted first, and of equals the first")
{
    CHECK(letters_in(joined({ordered('a', 2), ordered('b', 1), ordered('c', 2), ordered('d', 1)})) == "bdac");
    CHECK(letters_in(joined({ordered('a', 1), letter('b'), ordered('c', -1), letter('d')})) == "cbda");
    CHECK(letters_in(joined({ordered('a', 32767), ordered('b', -32768), ordered('c', 32767),
                             ordered('d', -32768)})) == "bdac");
    CHECK(letters_in(ordered('a', 7)) == "a");
}

TEST_CASE("the order changes with time")
{
    const Bytes items =
        joined({letter('a'),
                letter('b', moving_track(Property::order, {{Time::frame(2), 0, 0}, {Time::frame(4), 0, -1}})),
                letter('c', moving_track(Property::order, {{{}, 0, 3}, {Time::frame(6), 0, -2}}))});
    CHECK(letters_in(items) == "abc");
    CHECK(letters_in(items, {4 * 1024 - 1}) == "abc");
    CHECK(letters_in(items, Time::frame(4)) == "bac");
    CHECK(letters_in(items, Time::frame(6)) == "cba");
}

TEST_CASE("items are ordered among those beside them only, in groups and symbols")
{
    const Bytes inside = joined({ordered('x', 9), ordered('y', -9)});
    CHECK(letters_in(joined({group(inside), ordered('b', -1)})) == "byx");
    CHECK(letters_of(scene_of(joined({use(0), ordered('b', -1), use(0)}), {inside})) == "byxyx");
}

TEST_CASE("any orders are those of a stable sort")
{
    std::mt19937 random{61};
    for (int round = 0; round < 300; ++round) {
        std::vector<std::pair<int, char>> sorted;
        Bytes items;
        for (auto name = 'a'; name <= 'z'; ++name) {
            const int order = static_cast<int>(random() % 7) - 3;
            items = joined({items, order == 0 ? letter(name) : ordered(name, order)});
            sorted.emplace_back(order, name);
        }
        std::ranges::stable_sort(sorted, {}, &std::pair<int, char>::first);
        std::string expected;
        for (const auto& [order, name] : sorted)
            expected += name;
        REQUIRE(letters_in(items) == expected);
    }
}

TEST_CASE("what is not seen is passed, with all that lies within it")
{
    const Bytes hidden = joined({bytes({5, 1}), fixed_track(Property::visible, 0), block(letter('b'))});
    CHECK(letters_in(joined(
              {letter('a'), hidden, letter('c', fixed_track(Property::opacity, 0)), letter('d')})) == "ad");
}

TEST_CASE("groups of several layers are blended as a whole, others fade what lies within them")
{
    const Bytes pair = joined({letter('a'), letter('b')});
    CHECK(letters_in(faded_group(128, pair)) == "(ab)128");
    CHECK(letters_in(faded_group(255, pair)) == "ab");
    CHECK(letters_in(faded_group(128, letter('a'))) == "a");
    CHECK(letters_in(faded_group(128, faded_group(128, pair))) == "((ab)128)128");
    CHECK(letters_in(joined({faded_group(100, joined({faded_group(50, pair), letter('c')})), letter('d')})) ==
          "((ab)50c)100d");
    CHECK(letters_of(scene_of(faded_group(128, pair)), {}, SceneWalk::Opacity::of_leaves) == "ab");
}

TEST_CASE("opacities reach leaves unless they are those of a picture as a whole")
{
    using Step = SceneWalk::Step;
    const Bytes file = scene_of(joined({faded_group(128, letter('a', fixed_track(Property::opacity, 128))),
                                        faded_group(128, joined({letter('b'), letter('c')}))}));
    const SceneView scene = accepted(file);
    MovedScene moved{scene};
    const SceneOnPanel shown = moved.on_panel_at({});
    SceneWalk walk{shown, SceneWalk::Opacity::of_groups};
    REQUIRE(walk.next() == Step::leaf);
    CHECK(walk.leaf_opacity() == 64);
    REQUIRE(walk.next() == Step::begin_group);
    REQUIRE(walk.next() == Step::leaf);
    CHECK(walk.leaf_opacity() == 255);
    SceneWalk each{shown, SceneWalk::Opacity::of_leaves};
    each.next();
    CHECK(each.leaf_opacity() == 64);
    each.next();
    CHECK(each.leaf_opacity() == 128);
}

TEST_CASE("a leaf lies where all around it put it, and has a path of its own wherever it is used")
{
    const auto shifted = [](int pixels, const Bytes& items) {
        return joined({bytes({5, 1}), fixed_track(Property::x, 16 * pixels), block(items)});
    };
    const Bytes file = scene_of(joined({shifted(3, shifted(4, use(0))), use(0)}),
                                {joined({letter('a', fixed_track(Property::x, 16)), letter('b')})});
    const SceneView scene = accepted(file);
    MovedScene moved{scene};
    const SceneOnPanel shown = moved.on_panel_at({});
    SceneWalk walk{shown, SceneWalk::Opacity::of_groups};
    std::vector<std::int64_t> pixels;
    std::vector<std::uint32_t> paths;
    std::vector<std::size_t> depths;
    while (walk.next() == SceneWalk::Step::leaf) {
        pixels.push_back(walk.space().plane.x0 / Fixed::one);
        paths.push_back(walk.path());
        depths.push_back(walk.depth());
        CHECK(&walk.node(walk.depth() - 1) == &walk.node());
    }
    CHECK(pixels == std::vector<std::int64_t>{8, 7, 1, 0});
    CHECK(depths == std::vector<std::size_t>{4, 4, 2, 2});
    std::ranges::sort(paths);
    CHECK(std::ranges::adjacent_find(paths) == paths.end());
}

TEST_CASE("colours and opacities move the picture, but not the outlines of a leaf")
{
    const std::vector<RawTrackKey> fading{{{}, 0, 255}, {Time::frame(5), 0, 9}};
    const Bytes file = scene_of(joined({letter('a', moving_track(Property::opacity, fading)),
                                        letter('b', moving_track(Property::x, fading))}));
    const SceneView scene = accepted(file);
    MovedScene moved{scene};
    const SceneOnPanel shown = moved.on_panel_at(Time::frame(1));
    SceneWalk walk{shown, SceneWalk::Opacity::of_groups};
    walk.next();
    CHECK(walk.leaf_dependence() == Dependence{});
    CHECK(walk.whole() == Dependence{0b01, 0b01});
    walk.next();
    CHECK(walk.leaf_dependence() == Dependence{0b10, 0b10});
    CHECK(walk.place_dependence() == Dependence{0b10, 0b10});
    walk.next();
    CHECK(walk.whole() == Dependence{0b11, 0b11});
}

}
