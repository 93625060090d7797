#include "host/compiler/write_scene.hpp"

#include "core/scene/kfb_limits.hpp"
#include "core/scene/scene_view.hpp"
#include "host/compiler/limits/allowance.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

#include <string>

namespace kfast::test {
namespace {

/// A drawing of `count` lines, `count` + 1 points.
scene::Drawing many_lines(int count)
{
    scene::Stroke stroke;
    for (int i = 1; i <= count; ++i)
        stroke.segments.push_back(
            {.cubic = false, .c1 = {}, .c2 = {}, .to = {static_cast<std::int16_t>(i % 2), 0}});
    return {{stroke}};
}

scene::Item at(std::size_t place, scene::Item item)
{
    item.place = {place, 1};
    return item;
}

/// Of what the format limits, empty if it holds the scene.
std::string beyond_format(const scene::Scene& scene)
{
    Diagnostics diagnostics;
    check_allowances(scene, diagnostics);
    return diagnostics.has_errors() ? diagnostics.sorted().front().message : std::string{};
}

Diagnostic refusal(const scene::Scene& scene)
{
    Diagnostics diagnostics;
    REQUIRE(!write_scene(scene, diagnostics));
    REQUIRE(diagnostics.sorted().size() == 1);
    return diagnostics.sorted().front();
}

std::vector<scene::Item> uses(std::size_t count, std::size_t symbol)
{
    return std::vector<scene::Item>(count, item(scene::Use{symbol}));
}

}

TEST_CASE("too many items are an error at the use with the most")
{
    scene::Scene scene = scene_of(uses(255, 1), {{"dust", {}}, {"cloud", uses(256, 0)}});
    CHECK(beyond_format(scene).empty()); // 255 * 257 = 65535
    scene.items.push_back(at(5, item(scene::Group{})));
    CHECK(
        refusal(scene).message ==
        "the scene needs 65536 items, the format holds 65535; this use of symbol \"cloud\" alone needs 257");
}

TEST_CASE("items are counted as they are written, too, and so are their tracks")
{
    const auto empty_groups = [](std::size_t count) {
        return std::vector<scene::Item>(count, item(scene::Group{}));
    };
    scene::Scene scene = scene_of({item(scene::Use{0})}, {{"dust", empty_groups(65'532)}});
    CHECK(beyond_format(scene).empty());
    scene.symbols.front().items.push_back(at(5, item(scene::Group{})));
    CHECK(refusal(scene).message ==
          "the scene needs 65534 items as they are written, the format holds 65533; "
          "this group alone needs 1");
}

TEST_CASE("symbols that multiply beyond all numbers are refused too")
{
    std::vector<scene::Symbol> symbols{{"0", {item(filled({key(0, many_lines(10))}))}}};
    for (std::size_t i = 0; i < 7; ++i)
        symbols.push_back({std::to_string(i + 1), uses(2000, i)});
    Diagnostics diagnostics;
    CHECK(!write_scene(scene_of(uses(2000, 7), symbols), diagnostics));
    CHECK(diagnostics.sorted().size() == 2); // items, and steps of painting
}

TEST_CASE("steps of painting count wherever they are seen, two more for what fades as a whole")
{
    scene::Object both = filled({key(0, {})});
    both.stroke = scene::StrokeStyle{};
    const std::vector<scene::Item> dots(100, item(both, {fixed(Property::visible, 0)}, "dot"));
    scene::Scene scene = scene_of(uses(327, 0), {{"dots", dots}}); // 65400
    const std::vector<scene::Item> faded(33, item(both, {fixed(Property::opacity, 99)}, "faded"));
    scene.items.insert(scene.items.end(), faded.begin(), faded.end()); // 132
    scene.items.push_back(item(both, {}, "last"));
    scene.items.push_back(item(filled({key(0, {})})));
    const auto bytes = written(scene);
    CHECK(SceneView::parse(bytes)->paint_steps() == kfb::max_paint_steps);
    scene.items.push_back(item(filled({key(0, {})}), {fixed(Property::opacity, 99)}));
    CHECK(refusal(scene).message ==
          "the scene needs 65536 steps of painting, the format holds 65535; this use "
          "of symbol \"dots\" alone needs 200");
    const scene::Item dot = item(filled({key(0, {})}));
    scene.items.back() = item(scene::Group{{dot}}, {fixed(Property::opacity, 99)});
    CHECK(refusal(scene).message.find("needs 65536 steps") != std::string::npos);
    scene.items.back() = item(scene::Group{{dot, dot}}, {fixed(Property::opacity, 99)});
    CHECK(refusal(scene).message.find("needs 65539 steps") != std::string::npos);
    scene.items.back() = item(scene::Group{}, {fixed(Property::opacity, 99)});
    CHECK(written(scene).size() > bytes.size());
}

TEST_CASE("what a player would read too long is an error")
{
    scene::Object heavy = filled({});
    const auto add_keys = [&heavy](int count) {
        for (; count > 0; --count) {
            const auto frame = static_cast<int>(heavy.keys.size());
            scene::Drawing drawing;
            drawing.strokes.emplace_back().segments.resize(static_cast<std::size_t>(60'000 + frame));
            heavy.keys.push_back(key(frame, drawing));
        }
    };
    add_keys(6);
    const auto hidden = [&heavy] {
        return scene_of({at(7, item(heavy, {fixed(Property::visible, 0)}, "h"))});
    };
    CHECK(written(hidden()).size() > 0); // 360,000 points in 100 KB
    add_keys(8);
    const Diagnostic error = refusal(hidden());
    CHECK(error.place.offset == 7);
    CHECK(error.message.starts_with(
        "the scene has more keys, and points in their drawings, than a player reads of one of "));
}

TEST_CASE("a picture that takes longer than a second is an error at the item that takes most")
{
    const scene::Symbol leaves{"leaves",
                               std::vector<scene::Item>(50, item(filled({key(0, many_lines(10))})))};
    scene::Scene scene = scene_of(uses(100, 0), {leaves});
    scene.items.front().place = {3, 1};
    CHECK(written(scene).size() > 0); // 5000 leaves of 9 thousand instructions each
    scene.items.push_back(at(5, item(filled({key(0, many_lines(2'000))}), {}, "large")));
    scene.items.push_back(at(9, item(scene::Group{uses(80, 0)})));
    const Diagnostic error = refusal(scene);
    CHECK(error.place.offset == 5);
    CHECK(error.message == "a picture of the scene takes a Pico (RP2040) longer than a second; object "
                           "\"large\" takes most of it");
    scene.items[100] = item(scene::Group{}, {}, {});
    CHECK(refusal(scene).message.ends_with("this use of symbol \"leaves\" takes most of it"));
}

TEST_CASE("the compiler does not match strokes by length for ever")
{
    scene::Drawing dots;
    dots.strokes.assign(1'000, lines({{0, 0}, {16, 0}}).strokes.front());
    scene::Object object = filled({});
    for (int frame = 0; frame < 10; ++frame) {
        object.keys.push_back(key(frame, dots));
        object.keys.back().match = scene::Match::length;
    }
    const auto said_of = [](const scene::Scene& scene) {
        Diagnostics diagnostics;
        check_matching(scene, diagnostics);
        return diagnostics.has_errors() ? diagnostics.sorted().front().message : std::string{};
    };
    CHECK(said_of(scene_of({item(object, {}, "dots")})) ==
          "the scene needs 9000 strokes matched by length, the compiler takes 8192; "
          "object \"dots\" alone needs 9000");
    object.keys.front().match = scene::Match::count;
    CHECK(said_of(scene_of({item(object, {}, "dots")})).empty());
}

}
