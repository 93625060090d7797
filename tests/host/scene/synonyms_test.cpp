#include "host/words/synonyms.hpp"

#include "host/scene/language_schema.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace kfast::test {
namespace {

std::string in_object(const std::string& properties, const std::string& inside = "circle 9 9 r=3")
{
    return read_on_canvas("object o stroke=red " + properties + " { " + inside + " }").findings;
}

bool calls(const std::string& findings, const std::string& word)
{
    return findings.find("(KFAST calls it \"" + word + "\")") != std::string::npos;
}

bool refers_to_absent(const std::string& findings, const std::string& things)
{
    return findings.find("(there are no " + things + ": docs/scene-language.md#not-there has") !=
           std::string::npos;
}

}

TEST_CASE("words of CSS and SVG are translated")
{
    CHECK(in_object("rotation=9") ==
          "3:21 error: object has no property \"rotation\" (KFAST calls it \"rotate\")");
    CHECK(calls(in_object("stroke-width=2"), "width"));
    CHECK(calls(in_object("color=red"), "fill"));
    CHECK(calls(in_object("colour=red"), "fill"));
    CHECK(calls(in_object("", "rect 1 1 9 9 radius=2"), "corner"));
    CHECK(calls(in_object("", "rect 1 1 9 9 rx=2"), "corner"));
    CHECK(calls(in_object("", "circle 9 9 r=1 radius=2"), "r"));
    CHECK(calls(in_object("", "triangle 1 1 9 9 9 1"), "polygon"));
    CHECK(calls(in_object("", "key 0 ease=hold { circle 9 9 r=1 }; key 9 x=1"), "law"));
    CHECK(calls(in_object("", "key 0 law=step { circle 9 9 r=1 }; key 9 { circle 9 9 r=2 }"), "hold"));
    CHECK(calls(in_object("strokeWidth=2"), "width"));
    CHECK(calls(in_object("Stroke-Width=2"), "width"));
    CHECK(calls(in_object("scale_x=2"), "scale-x"));
    CHECK(calls(in_object("", "circle 9 9 r=1; track rotation { at 0 0; at 9 1 }"), "rotate"));
    CHECK(calls(read_on_canvas("layer { object o fill=red { circle 9 9 r=1 } }").findings, "group"));
    CHECK(calls(read("kfast 1\ncanvas 9 9 loop=forever\n").findings, "repeat"));
}

TEST_CASE("a property of objects at a shape is sent there")
{
    CHECK(in_object("", "circle 9 9 r=3 fill=red") ==
          "3:39 error: circle has no property \"fill\" (objects have it: object NAME fill=…)");
    CHECK(in_object("", "circle 9 9 r=3 stroke-width=2") ==
          "3:39 error: circle has no property \"stroke-width\" (objects have it: object NAME width=…)");
    CHECK(calls(in_object("", "star 9 9 r=3 rotate=9"), "turn"));
    CHECK(calls(read_on_canvas("repeat 8 { }").findings, "use"));
    CHECK(calls(read_on_canvas("use s stagger=2\nsymbol s { object p fill=red { rect 0 0 1 1 } }").findings,
                "delay-step"));
    const auto in_use = [](const std::string& property) {
        return read_on_canvas("use s " + property + "\nsymbol s { object p fill=red { rect 0 0 1 1 } }")
            .findings;
    };
    CHECK(calls(in_use("repeat=2"), "count"));
    CHECK(in_use("duration=2").find("(the symbol has it: symbol NAME frames=…)") != std::string::npos);
    CHECK(calls(read("kfast 1\ncanvas 9 9 repeat=forever\n").findings, "loop"));
    CHECK(calls(read_on_canvas("symbol s duration=9 { object p fill=red { rect 0 0 1 1 } }\nuse s").findings,
                "frames"));
}

TEST_CASE("what there is not is said with the page that has another way")
{
    CHECK(refers_to_absent(in_object("gradient=red"), "gradients"));
    CHECK(refers_to_absent(in_object("mask=m"), "masks"));
    CHECK(refers_to_absent(in_object("", "key 0 law=step-start { circle 9 9 r=1 }; key 9 { circle 9 9 r=2 }"),
                           "jumps at the beginning"));
    CHECK(refers_to_absent(read_on_canvas("image \"a.png\"").findings, "images"));
    CHECK(refers_to_absent(read_on_canvas("state idle { }").findings, "states"));
    CHECK(hint_of_absent("circle") == "");
}

TEST_CASE("each word of another program stands once with each meaning, as it is looked up")
{
    std::set<std::pair<std::string_view, std::string_view>> rows;
    for (const Synonym& row : synonyms()) {
        CAPTURE(row.word);
        CAPTURE(row.meaning);
        CHECK(rows.emplace(row.word, row.meaning).second);
        CHECK(row.word != row.meaning);
        CHECK(meaning_among(std::array{row.meaning}, row.word) == row.meaning);
    }
}

TEST_CASE("no word that a node has is one of another program there")
{
    const auto words = scene::language_schema();
    for (const schema::NodeSchema& node : words.nodes) {
        std::set<std::string_view> names;
        for (const schema::PropertySchema& property : node.properties)
            names.insert(property.name);
        for (const Synonym& row : synonyms()) {
            CAPTURE(node.id);
            CAPTURE(row.word);
            CAPTURE(row.meaning);
            CHECK_FALSE((names.contains(row.word) && names.contains(row.meaning)));
        }
    }
}

TEST_CASE("other words have a suggestion")
{
    CHECK(word_hint("cirle", std::array<std::string_view, 2>{"circle", "rect"}) ==
          "did you mean \"circle\"?");
    CHECK(word_hint(std::string(1000, 'a'), std::array<std::string_view, 1>{"rect"}) == "allowed: rect");
}

}
