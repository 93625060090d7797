#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

/// Inputs that are drawings, and objects that show them.
namespace kfast::test {
namespace {

/// Of an input that an object shows; the input is on line 1.
SceneText read_input(const std::string& input)
{
    return read_on_canvas(input + "\nobject o fill=red live=a");
}

std::string findings(const std::string& input) { return read_input(input).findings; }

/// Of objects behind an input that they may show.
std::string findings_with(const std::string& items)
{
    return read_on_canvas("input a kind=drawing points=9 { line 2 2 10 6 }\ninput n\n" + items +
                          "\nobject p fill=red live=a { track x input=n { at 0 0 } }")
        .findings;
}

}

TEST_CASE("an input that is a drawing has a room and a usual drawing")
{
    const SceneText plain = read_input("input a kind=drawing points=9");
    CAPTURE(plain.findings);
    REQUIRE(plain.scene);
    const scene::Input& input = plain.scene->inputs.front();
    CHECK(input.name == "a");
    CHECK(input.type == InputType::drawing);
    CHECK(input.drawing.points == 9);
    CHECK(input.drawing.strokes == 1);
    CHECK(input.drawing.default_value.strokes.empty());

    const SceneText full =
        read_input("input a strokes=2 points=7 kind=drawing { line 1 1 2 2.5 0 0; rect 1 1 2 2 }; /-input b");
    CHECK(full.findings == "3:19 error: the drawing inside has 8 points (write points=8, or draw less)");
    const SceneText good =
        read_input("input a strokes=2 points=8 kind=drawing { line 1 1 2 2.5 0 0; polygon 1 1 2 2 3 1 }");
    CAPTURE(good.findings);
    REQUIRE(good.scene);
    const scene::Drawing& default_value = good.scene->inputs.front().drawing.default_value;
    REQUIRE(default_value.strokes.size() == 2);
    CHECK(default_value.strokes[0].segments[0].to == scene::Point{32, 40});
    CHECK(default_value.strokes[1].segments.size() == 3);
}

TEST_CASE("what is wrong with a drawing input is told")
{
    CHECK(findings("input a kind=drawing").starts_with("3:1 error: input needs the property \"points\""));
    CHECK(findings("input a kind=draw points=3").starts_with("3:14 error:"));
    CHECK(findings("input a kind=drawing points=0")
              .starts_with("3:29 error: this number is out of range (allowed: 1 to "));
    CHECK(findings("input a kind=drawing points=4097").find("allowed: 1 to 4096") != std::string::npos);
    CHECK(findings("input a kind=drawing points=2.5").starts_with("3:29 error:"));
    CHECK(findings("input a kind=drawing points=3 strokes=4") ==
          "3:31 error: these are more strokes than points (each stroke has a point at least)");
    CHECK(findings("input a kind=drawing points=9 { line 0 0 1 1; line 2 2 3 3 }") ==
          "3:1 error: the drawing inside has 2 strokes (write strokes=2, or draw less)");
    CHECK(
        findings("input a kind=drawing points=9 { circle 5 5 r=2 }")
            .starts_with("3:33 error: the drawing of an input has straight lines only (draw it with lines"));
    CHECK(findings("input a kind=drawing points=9 { lime 0 0 1 1 }") ==
          "3:33 error: the drawing of an input has no node \"lime\" (did you mean \"line\"?)");
    CHECK(findings("input a kind=drawing points=9 { key 0 { line 0 0 1 1 } }").find("has no node \"key\"") !=
          std::string::npos);
    CHECK(findings("input a kind=drawing points=9 min=0")
              .starts_with("3:31 error: input has no property \"min\""));
    CHECK(findings("input a points=9").find("input has no property \"points\"") != std::string::npos);
    CHECK(findings("input a kind=number { line 0 0 1 1 }").find("input takes no nodes inside") !=
          std::string::npos);
}

TEST_CASE("an object shows an input of the right kind, and has no drawing of its own")
{
    CHECK(findings_with("object o fill=red live=a").empty());
    CHECK(findings_with("object o fill=red live=a { key 0 x=1 fill=red; key 9 x=2 fill=blue; track y { at 0 "
                        "1; at 9 2 } }")
              .empty());
    CHECK(findings_with("object o fill=red live=b") == "5:24 error: unknown input \"b\" (allowed: a)");
    CHECK(
        findings_with("object o fill=red live=n") ==
        "5:24 error: the input \"n\" is a number, not a drawing (live= shows a drawing; keys go by numbers)");
    CHECK(
        findings_with("object o fill=red { rect 0 0 2 2; track x input=a { at 0 0 } }") ==
        "5:49 error: the input \"a\" is a drawing, not a number (keys go by numbers; live= shows a drawing)");
    CHECK(findings_with("object o live=a").find("it has neither fill nor stroke") != std::string::npos);
    for (const std::string inside :
         {"rect 0 0 2 2", "use s", "key 0 { rect 0 0 2 2 }",
          "key 0 { skeleton { backbone 0 0 9 0; width 2 } }", "weights { at 0 b }"})
        CHECK(findings_with("symbol s { line 0 0 1 1 }\nobject o fill=red live=a { " + inside + " }")
                  .find("this object shows an input, and has no drawing or skeleton of its own (put shapes "
                        "into the "
                        "input, or remove live=…)") != std::string::npos);
    CHECK(findings_with("bones s { bone b 0 0 9 0 }\nobject o fill=red skin=s live=a")
              .find("this object shows an input") != std::string::npos);
    CHECK(read_on_canvas("object o fill=red live=a")
              .findings.find("unknown input \"a\" (add \"input a kind=drawing points=100\" to the scene)") !=
          std::string::npos);
}

TEST_CASE("an input that no object shows is told")
{
    CHECK(read_on_canvas("input a kind=drawing points=9\nobject o fill=red { rect 0 0 2 2 }").findings ==
          "3:1 warning: the input \"a\" shows nothing (add live=a to an object, or remove it)");
}

TEST_CASE("a live object turns about the middle of the usual drawing unless it says otherwise")
{
    const auto pivot = [](const std::string& input) {
        const SceneText read =
            read_on_canvas("input a kind=drawing points=9 " + input + "\nobject o fill=red live=a rotate=9");
        REQUIRE(read.scene);
        std::vector<std::int32_t> values;
        for (const scene::Track& track : read.scene->items.front().tracks)
            if (track.property == Property::pivot_x || track.property == Property::pivot_y)
                values.push_back(track.keys.front().value);
        return values;
    };
    CHECK(pivot("{ line 2 2 10 6 }") == std::vector<std::int32_t>{96, 64});
    CHECK(pivot("").empty());
}

}
