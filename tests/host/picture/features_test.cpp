#include "core/features.hpp"

#include "core/bytes/result.hpp"
#include "core/player.hpp"
#include "tests/chosen_features.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::string_view head = "kfast 1\ncanvas 40 40 frames=5\n";

/// Needs the features beside it, no more and no less.
struct Case {
    FeatureSet needed;
    std::string_view text;
};

constexpr std::array cases{
    Case{
        {},
        R"(group g opacity=0.5 { object o fill=red { rect 5 5 9 9; key 0 x=0 fill=red; key 4 x=9 y=3 rotate=70 scale=2 fill=blue }
object p fill=lime { circle 9 9 r=8 } })"},
    Case{{Feature::tweens},
         "object p fill=lime { key 0 { circle 9 9 r=8 }; key 4 { star 20 20 points=5 r=9 inner=4 } }"},
    Case{{}, "group g scale-x=2 { object p fill=lime { circle 9 9 r=8; key 0 rotate=0; key 4 rotate=50 } }"},
    Case{{Feature::bones, Feature::tweens},
         R"(bones arm { bone upper 10 20 20 20; pose 0 rest; pose 4 { upper turn=30 } }
object o fill=red skin=arm { key 0 { rect 10 16 20 8 }; key 4 { rect 12 10 9 20 } })"},
    Case{{Feature::strokes},
         "object o stroke=red width=3 { line 5 5 30 30 9 30; key 0 width=1; key 4 width=5 }"},
    Case{{Feature::bones}, R"(bones arm { bone upper 10 20 20 20 { bone lower 20 20 30 20 }
pose 0 rest; pose 4 { upper turn=30; lower turn=40 length=12 } }
object o fill=red skin=arm { rect 10 16 20 8 })"},
    Case{{Feature::backbones, Feature::tweens}, R"(object o fill=teal {
key 0 { path "M 6 16 C 6 10 14 11 20 11 C 30 11 38 12 38 16 C 38 20 30 21 20 21 C 14 21 6 22 6 16 Z"
skeleton { backbone 6 16 14 16 22 16 30 16 38 16; width 16 } }
key 4 { skeleton { backbone 8 20 14 14 22 8 30 14 36 20 } } })"},
    Case{{Feature::depth}, "object o fill=red { rect 5 5 20 20; key 0 rotate-y=0; key 4 rotate-y=60 z=3 }"},
    Case{{Feature::depth},
         "group g rotate-x=40 pivot-x=20 { object o fill=red { rect 5 5 20 20; key 0 x=0; key 4 x=3 } }"},
    Case{{Feature::wires, Feature::strokes}, "object o stroke=red width=2 { cuboid 10 10 0 9 9 9 }"},
    Case{{Feature::wires, Feature::strokes, Feature::depth},
         "object o stroke=red width=2 { cuboid 10 10 0 9 9 9; key 0 rotate-y=0; key 4 rotate-y=80 }"},
    Case{
        {Feature::paths},
        R"(object o fill=red { rect 0 0 6 6; track along "M 5 5 L 30 5 L 30 30" law=constant { at 0 0; at 4 1 } })"},
    Case{{Feature::smooth}, R"(object o fill=red { rect 0 0 6 6
track x { at 0 0; at 2 20; at 4 9 } })"},
    Case{{Feature::springs}, R"(object o fill=red { rect 0 0 6 6; key 0 x=0 law-x=spring; key 4 x=20 })"},
    Case{{Feature::springs}, R"(object o fill=red { rect 0 0 6 6; key 0 y=0 law-y=bounce-in; key 4 y=20 })"},
    Case{{Feature::texts, Feature::strokes}, R"(input word kind=text glyphs="A-Z" max=3 default="AB"
object o stroke=red width=1 { text input=word at="2,20" size=12 })"},
    Case{{Feature::drawings}, R"(input area kind=drawing points=9 { line 5 5 30 9 12 30 }
object o fill=red live=area { key 0 y=0; key 4 y=6 })"},
    Case{{Feature::trims, Feature::strokes},
         "object o stroke=red width=3 { circle 20 20 r=9; key 0 trim-to=0; key 4 trim-to=1 }"},
    Case{{Feature::trims}, "object o fill=red trim-to=0.3 { rect 5 5 20 20; key 0 x=0; key 4 x=6 }"},
};

Features only(FeatureSet set)
{
    return features_where([set](Feature feature) { return set.has(feature); });
}

std::vector<std::byte> played(std::span<const std::byte> scene, const Features& features)
{
    const auto view = SceneView::parse(scene, features);
    REQUIRE(view);
    std::vector<std::uint32_t> block(Player::block_bytes(*view, view->canvas()) / 4 + 1);
    Player player{*view, view->canvas(), Fit::contain,
                  std::as_writable_bytes(std::span{block}).first(Player::block_bytes(*view, view->canvas()))};
    std::vector<std::byte> film;
    for (int frame = 0; frame < 5; ++frame) {
        player.show(Time::frame(frame));
        std::vector<std::byte> pixels(40 * 40 * 2);
        player.draw_rows<PixelFormat::rgb565>(40, pixels);
        film.insert(film.end(), pixels.begin(), pixels.end());
    }
    return film;
}

FeatureSet without(FeatureSet set, std::size_t left_out)
{
    FeatureSet rest;
    for (std::size_t number = 0; number < feature_count; ++number)
        if (number != left_out && set.has(static_cast<Feature>(number)))
            rest.add(static_cast<Feature>(number));
    return rest;
}

}

TEST_CASE("a scene plays with what it needs as with everything, and is refused by name without")
{
    FeatureSet seen;
    for (const Case& each : cases) {
        CAPTURE(each.text);
        const FeatureSet needed = each.needed;
        const auto scene = compiled(std::string{head} + std::string{each.text});
        CHECK(SceneView::parse(scene)->needed_features() == needed);
        CHECK(played(scene, only(needed)) == played(scene, every_feature));
        for (std::size_t number = 0; number < feature_count; ++number) {
            const auto feature = static_cast<Feature>(number);
            if (!needed.has(feature))
                continue;
            seen.add(feature);
            const Features features = only(without(needed, number));
            CHECK_FALSE(features.has(feature));
            const auto refused = SceneView::parse(scene, features);
            REQUIRE_FALSE(refused);
            CHECK(static_cast<int>(refused.error()) ==
                  static_cast<int>(Error::needs_strokes) + static_cast<int>(number));
        }
    }
    for (std::size_t number = 0; number < feature_count; ++number)
        CHECK(seen.has(static_cast<Feature>(number)));
}

TEST_CASE("what a program lacks has a name")
{
    CHECK(error_text(Error::needs_strokes) == "needs_strokes: the program was built without strokes");
    CHECK(error_text(Error::needs_drawings) ==
          "needs_drawings: the program was built without drawings as inputs");
    CHECK(error_text(Error::needs_trims) ==
          "needs_trims: the program was built without strokes that are drawn in part or dashed");
    CHECK(error_text(Error::needs_springs) ==
          "needs_springs: the program was built without springs and bounces");
}

}
