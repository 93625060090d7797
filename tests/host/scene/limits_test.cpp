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
        objects += "object o" + number + " fill=\"#" + number + "\" { key 0 }\n";
    }
    return objects;
}

auto line_count(const std::string& text) { return std::ranges::count(text, '\n') + 1; }

}

TEST_CASE("a drawing holds 65535 points and no more")
{
    const auto full = read_on_canvas("object o fill=red { path \"" + lines_to(65'534) + "\" }");
    REQUIRE(full.scene);
    CHECK(full.scene->objects[0].keys[0].drawing.strokes[0].segments.size() == 65'534);
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
        keys += "key " + std::to_string(i) + '\n';
    CHECK(read_on_canvas("object o fill=red {\n" + keys + "}").scene);
    CHECK(read_on_canvas("object o fill=red {\n" + keys + "key 65535\n}").findings ==
          "65539:1 error: an object holds at most 65535 keys");
}

TEST_CASE("65535 objects and no more")
{
    std::string objects;
    for (int i = 0; i < 65'535; ++i)
        objects += "object o" + std::to_string(i) + " fill=red { key 0 }\n";
    CHECK(read_on_canvas(objects).scene->objects.size() == 65'535);
    CHECK(read_on_canvas(objects + "object last fill=red { key 0 }").findings ==
          "65538:1 error: a scene holds at most 65535 objects");
}

TEST_CASE("after 100 errors or warnings there is one last word")
{
    const std::string errors = read_on_canvas(repeat("what\n", 5'000)).findings;
    CHECK(line_count(errors) == 101);
    CHECK(errors.ends_with("103:1 error: too many errors; what follows was not checked"));
    const std::string warnings =
        read_on_canvas("object o fill=red {\n" + repeat("path \"\"\n", 5'000) + "}").findings;
    CHECK(line_count(warnings) == 101);
    CHECK(warnings.ends_with("104:6 warning: too many warnings; the others are not shown"));
}

}
