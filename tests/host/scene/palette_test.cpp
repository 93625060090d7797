#include "host/scene/context/palette.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// The colour of an object's fill.
Colour filled(const std::string& colour)
{
    const auto scene = read_on_canvas("object o fill=" + colour + " { key 0 { empty } }").scene;
    REQUIRE(scene);
    return scene->palette.at(*object_at(*scene).fill);
}

}

TEST_CASE("colours are hexadecimal in four lengths and either case")
{
    CHECK(filled("\"#4cc9f0\"") == Colour{0x4C, 0xC9, 0xF0});
    CHECK(filled("\"#4CC9F0\"") == Colour{0x4C, 0xC9, 0xF0});
    CHECK(filled("\"#4cf\"") == Colour{0x44, 0xCC, 0xFF});
    CHECK(filled("\"#4cc9f080\"") == Colour{0x4C, 0xC9, 0xF0, 0x80});
    CHECK(filled("\"#4CC9F0FF\"") == Colour{0x4C, 0xC9, 0xF0});
    CHECK(filled("\"#4cf0\"") == Colour{0x44, 0xCC, 0xFF, 0});
    CHECK(filled("\"#4cf8\"") == Colour{0x44, 0xCC, 0xFF, 0x88});
}

TEST_CASE("the colours of CSS need no palette")
{
    CHECK(filled("black") == Colour{0, 0, 0});
    CHECK(filled("silver") == Colour{192, 192, 192});
    CHECK(filled("gray") == Colour{128, 128, 128});
    CHECK(filled("grey") == Colour{128, 128, 128});
    CHECK(filled("white") == Colour{255, 255, 255});
    CHECK(filled("maroon") == Colour{128, 0, 0});
    CHECK(filled("red") == Colour{255, 0, 0});
    CHECK(filled("purple") == Colour{128, 0, 128});
    CHECK(filled("fuchsia") == Colour{255, 0, 255});
    CHECK(filled("green") == Colour{0, 128, 0});
    CHECK(filled("lime") == Colour{0, 255, 0});
    CHECK(filled("olive") == Colour{128, 128, 0});
    CHECK(filled("yellow") == Colour{255, 255, 0});
    CHECK(filled("navy") == Colour{0, 0, 128});
    CHECK(filled("blue") == Colour{0, 0, 255});
    CHECK(filled("teal") == Colour{0, 128, 128});
    CHECK(filled("aqua") == Colour{0, 255, 255});
    CHECK(filled("orange") == Colour{255, 165, 0});
    CHECK(filled("aliceblue") == Colour{240, 248, 255});
    CHECK(filled("yellowgreen") == Colour{154, 205, 50});
    CHECK(filled("rebeccapurple") == Colour{102, 51, 153});
    CHECK(filled("darkslategrey") == filled("darkslategray"));
    CHECK(scene::known_colour_names().size() == 148);
}

TEST_CASE("the scene holds the colours in use, each once, the background first")
{
    const auto [scene, findings] =
        read("kfast 1\n"
             "canvas 9 9 background=navy\n"
             "palette { ink \"#f2f2f2\"; unused \"#123456\"; red \"#e04040\"; night navy }\n"
             "object a fill=red stroke=ink { key 0 { empty } }\n"
             "object b fill=night stroke=\"#f2f2f2\" { key 0 { empty } }");
    REQUIRE(scene);
    CHECK(findings == "");
    CHECK(scene->palette == std::vector{Colour{0, 0, 128}, {0xE0, 0x40, 0x40}, {0xF2, 0xF2, 0xF2}});
    CHECK(object_at(*scene).fill == 1);
    CHECK(object_at(*scene).stroke->colour == 2);
    CHECK(object_at(*scene, 1).fill == 0);
    CHECK(object_at(*scene, 1).stroke->colour == 2);
}

TEST_CASE("a wrong colour is told from an unknown one")
{
    CHECK(read_on_canvas("palette { ink white }\nobject o fill=inc { key 0 { empty } }").findings ==
          "4:15 error: unknown colour \"inc\" (did you mean \"ink\"?)");
    CHECK(read_on_canvas("object o fill=ff0000 { key 0 { empty } }").findings ==
          "3:15 error: \"ff0000\" is no colour (write \"#ff0000\", with the quotes)");
    CHECK(read_on_canvas("object o fill=mauve { key 0 { empty } }").findings ==
          "3:15 error: unknown colour \"mauve\" (allowed: black, silver, gray, white, maroon, red, purple, "
          "fuchsia, green, lime, olive, yellow, navy, blue, teal, aqua, another colour of CSS, or "
          "\"#rrggbb\")");
    for (const std::string word : {"none", "transparent"})
        CHECK(read_on_canvas("object o stroke=red fill=" + word + " { key 0 { empty } }").findings ==
              "3:26 error: \"" + word +
                  "\" is no colour (leave the property out; a colour that is not seen is \"#0000\")");
    CHECK(read_on_canvas("object o fill=\"rgb(1, 2, 3)\" { key 0 { empty } }").findings ==
          "3:15 error: unknown colour \"rgb(1, 2, 3)\" (write \"#rrggbb\")");
    CHECK(read_on_canvas("object o fill=\"linear-gradient(red, blue)\" { key 0 { empty } }").findings ==
          "3:15 error: unknown colour \"linear-gradient(red, blue)\" (there are no gradients: "
          "docs/scene-language.md#not-there has what to write instead)");
    for (const std::string wrong : {"#12345", "#", "#12345g", "#123456789", "#-12", "#1234567", "#+12"})
        CHECK(read_on_canvas("object o fill=\"" + wrong + "\" { key 0 { empty } }").findings ==
              "3:15 error: \"" + wrong +
                  "\" is no colour (write \"#rgb\", \"#rrggbb\" or, with opacity, \"#rgba\", \"#rrggbbaa\")");
    CHECK(read_on_canvas("object o fill=3 { key 0 { empty } }").findings ==
          "3:15 error: a colour is expected here (write its name or \"#rrggbb\")");
    CHECK(read("kfast 1\ncanvas 9 9 background=vermilion-red-hot")
              .findings.starts_with("2:23 error: unknown colour \"vermilion-red-hot\""));
}

TEST_CASE("a name in the palette may stand for a transparent colour")
{
    const auto scene = read_on_canvas("palette { glass \"#ffff8080\" }\nobject o fill=glass { empty }").scene;
    REQUIRE(scene);
    CHECK(scene->palette.at(1) == Colour{255, 255, 128, 128});
}

TEST_CASE("a wrong colour in the palette is reported there, not again at its uses")
{
    CHECK(read_on_canvas("palette { ink \"#12345\" }\nobject o fill=ink { key 0 { empty } }").findings ==
          "3:15 error: \"#12345\" is no colour (write \"#rgb\", \"#rrggbb\" or, with opacity, \"#rgba\", "
          "\"#rrggbbaa\")");
}

TEST_CASE("a palette with mistakes")
{
    CHECK(read_on_canvas("palette { ink white\n ink black }").findings ==
          "4:2 error: there is a colour \"ink\" already, on line 3");
    CHECK(read_on_canvas("palette { ink }").findings ==
          "3:11 error: ink needs more values (write NAME \"#rrggbb\")");
    CHECK(read_on_canvas("palette { ink 1 }").findings ==
          "3:15 error: a word or a text in quotes is expected here");
    CHECK(read_on_canvas("palette { ink white; pen ink }")
              .findings.starts_with("3:26 error: unknown colour \"ink\""));
    CHECK(read_on_canvas("palette { ink white a=1 }").findings ==
          "3:21 error: ink has no property \"a\" (nothing is allowed here)");
    CHECK(read_on_canvas("palette { ink white { x } }").findings ==
          "3:23 error: ink takes no nodes inside (write NAME \"#rrggbb\")");
    CHECK(read_on_canvas("palette 3").findings ==
          "3:9 error: this value is too many for palette (write palette { NAME \"#rrggbb\" })");
}

}
