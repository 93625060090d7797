#include "host/compiler/write_scene.hpp"

#include "core/kfb_limits.hpp"
#include "core/scene_view.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

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
    CHECK(written(scene).size() > 0); // 255 * 257 = 65535
    scene.items.push_back(at(5, item(scene::Group{})));
    const Diagnostic error = refusal(scene);
    CHECK(
        error.message ==
        "the scene needs 65536 items, the format holds 65535; this use of symbol \"cloud\" alone needs 257");
}

TEST_CASE("items are counted as they are written, too, and so are their tracks")
{
    const auto empty_groups = [](std::size_t count) {
        return std::vector<scene::Item>(count, item(scene::Group{}));
    };
    scene::Scene scene = scene_of({item(scene::Use{0})}, {{"dust", empty_groups(65'532)}});
    CHECK(written(scene).size() > 0);
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
    const std::vector<scene::Item> dots(100, item(both, {}, "dot"));
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

TEST_CASE("points of all keys count, those of symbols once")
{
    scene::Object heavy = filled({});
    for (int frame = 0; frame < 64; ++frame)
        heavy.keys.push_back(key(frame, many_lines(65'534)));
    heavy.fill.reset();
    heavy.stroke = scene::StrokeStyle{};
    const auto used_twice = [&heavy] {
        return scene_of({item(scene::Use{0}), item(scene::Use{0})},
                        {{"s", {item(heavy, {fixed(Property::visible, 0)}, "h")}}});
    };
    CHECK(written(used_twice()).size() > 0); // 64 * 65536
    heavy.keys.push_back(key(64, {}));
    CHECK(refusal(used_twice()).message ==
          "the scene needs 4194305 points in all keys together, the format holds 4194304; "
          "object \"h\" alone needs 4194305");
}

}
