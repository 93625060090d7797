#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

std::string repeat(const std::string& text, std::size_t count)
{
    std::string all;
    for (std::size_t i = 0; i < count; ++i)
        all += text;
    return all;
}

std::string lines_to(std::size_t count)
{
    return "M 0 0 " + repeat("h1 h-1 ", count / 2) + (count % 2 != 0 ? "h1" : "");
}

std::string colours(std::size_t count)
{
    std::string objects;
    for (std::size_t i = 1; i <= count; ++i) {
        const std::string number = std::to_string(100'000 + i);
        objects += "object o" + number + " fill=\"#" + number + "\" { key 0 { empty } }\n";
    }
    return objects;
}

auto line_count(const std::string& text) { return std::ranges::count(text, '\n') + 1; }

}

TEST_CASE("a drawing holds 65535 points and no more")
{
    const auto full = read_on_canvas("object o fill=red { path \"" + lines_to(65'534) + "\" }");
    REQUIRE(full.scene);
    CHECK(key_at(*full.scene).drawing.strokes[0].segments.size() == 65'534);
    CHECK(path_drawn(lines_to(65'535)) == "1:229376 error: a drawing holds at most 65535 points");
    CHECK(read_on_canvas("object o fill=red { path \"" + lines_to(65'532) + "\"\n line 1 1 2 2 }").scene);
    CHECK(read_on_canvas("object o fill=red { path \"" + lines_to(65'533) + "\"\n line 1 1 2 2 }").findings ==
          "4:2 error: a drawing holds at most 65535 points");
    CHECK(read_on_canvas("object o fill=red { path \"" + lines_to(65'533) + "\"\n path \"M1 1h1\" }")
              .findings == "4:12 error: a drawing holds at most 65535 points");
}

TEST_CASE("255 colours with the background, and no more")
{
    CHECK(read_on_canvas(colours(254)).scene->palette.size() == 255);
    CHECK(read_on_canvas(colours(255)).findings ==
          "257:21 error: too many colours (a scene holds at most 255, background included)");
}

TEST_CASE("255 names in the palette, and no more")
{
    std::string names;
    for (int i = 1; i <= 256; ++i)
        names += 'c' + std::to_string(i) + " red\n";
    CHECK(read_on_canvas("palette {\n" + names + "}").findings ==
          "259:1 error: a palette holds at most 255 colours");
}

TEST_CASE("65535 keys and no more")
{
    std::string keys;
    for (int i = 0; i < 65'535; ++i)
        keys += "key " + std::to_string(i) + " { empty }\n";
    CHECK(read_on_canvas("object o fill=red {\n" + keys + "}").scene);
    CHECK(read_on_canvas("object o fill=red {\n" + keys + "key 65535 { empty }\n}").findings ==
          "65539:1 error: at most 65535 keys stand here");
}

TEST_CASE("256 items beside one with an order, itself included, and no more")
{
    const auto with_others = [](std::size_t count) {
        return read_on_canvas("group g order=1 { group { object o fill=red { circle 1 1 r=1 } } }\n" +
                              repeat("group { use s }\n", count) +
                              "symbol s { object p fill=red { circle 1 1 r=1 } }");
    };
    CHECK(with_others(255).findings == "");
    CHECK(with_others(256).findings ==
          "3:1 error: an item with an order lies among 257 items; the format holds 256 "
          "(put it into a group, together with those that it passes)");
}

TEST_CASE("255 symbols of items in use, and no more")
{
    std::string text;
    for (int i = 1; i <= 256; ++i) {
        const std::string name = std::to_string(i);
        text += "symbol s" + name + " { object o" + name + " fill=red { empty } }\n";
        text += i < 256 ? "use s" + name + '\n' : "";
    }
    CHECK(read_on_canvas(text).scene->symbols.size() == 255);
    CHECK(read_on_canvas(text + "use s256").findings ==
          "513:1 error: a scene uses at most 255 symbols that hold items");
}

TEST_CASE("4194304 points in all drawings together, copies counted")
{
    const std::string symbol = "symbol s { path \"" + lines_to(65'534) + "\" }\n";
    std::string objects;
    for (int i = 1; i <= 64; ++i)
        objects += "object o" + std::to_string(i) + " fill=red { use s }\n";
    CHECK(read_on_canvas(symbol + objects).findings ==
          "67:23 error: the drawings of a scene hold at most 4194304 points");
    CHECK(read_on_canvas(symbol + objects.substr(0, objects.rfind("object"))).scene);
    std::string keys;
    for (int i = 1; i <= 64; ++i)
        keys += "key " + std::to_string(i) + " { use s }\n";
    CHECK(read_on_canvas("object o fill=red {\n" + keys + "}\n" + symbol).findings ==
          "67:10 error: the drawings of a scene hold at most 4194304 points");
}

TEST_CASE("after 99 errors or warnings there is one last word")
{
    const std::string errors = read_on_canvas(repeat("what\n", 5'000)).findings;
    CHECK(line_count(errors) == 100);
    CHECK(errors.ends_with("102:1 error: too many errors; what follows was not checked"));
    const std::string warnings =
        read_on_canvas("object o fill=red {\n" + repeat("path \"\"\n", 5'000) + "}").findings;
    CHECK(line_count(warnings) == 100);
    CHECK(warnings.ends_with("103:6 warning: too many warnings; the others are not shown"));
}

}
