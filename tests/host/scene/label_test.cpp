#include "tests/host/scene/scene_text.hpp"

#include "core/scene/kfb_limits.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// What is found in a scene with this input, on line 3, that an object shows.
std::string findings(const std::string& input,
                     const std::string& text = "text input=t at=\"9,9\" size=32 font=hershey-sans",
                     const std::string& object = "")
{
    return read_on_canvas(input + "\nobject o stroke=red " + object + " {\n" + text + "\n}").findings;
}

scene::TextInput text_input(const std::string& properties)
{
    const SceneText read =
        read_on_canvas("input t kind=text " + properties +
                       "\nobject o stroke=red { text input=t at=\"9,9\" size=32 font=hershey-sans }");
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    CHECK(read.findings.empty());
    CHECK(read.scene->inputs.front().type == InputType::text);
    return read.scene->inputs.front().text;
}

scene::Label label(const std::string& properties, const std::string& glyphs = "I")
{
    const SceneText read = read_on_canvas("input t kind=text max=3 glyphs=" + glyphs +
                                          "\nobject o stroke=red { text input=t " + properties + " }");
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    CHECK(object_at(*read.scene).keys.empty());
    return *object_at(*read.scene).label;
}

constexpr const char* plain = "input t kind=text glyphs=ab max=3";

}

TEST_CASE("glyphs are characters and ranges of them, and the space")
{
    CHECK(text_input("glyphs=\"0-9:%\" max=8").glyphs == U" %0123456789:");
    CHECK(text_input("glyphs=cab max=8").glyphs == U" abc");
    CHECK(text_input("glyphs=\"a-\" max=8").glyphs == U" -a");
    CHECK(text_input("glyphs=\"-a\" max=8").glyphs == U" -a");
    CHECK(text_input("glyphs=\"+--\" max=8").glyphs == U" +,-");
    CHECK(text_input("glyphs=\"a-c-e\" max=8").glyphs == U" -abce");
    CHECK(text_input("glyphs=\" \" max=8").glyphs == U" ");
    CHECK(text_input("glyphs=\"a-a\" max=1").max == 1);
    CHECK(text_input("glyphs=a max=60").max == 60);
    CHECK(text_input("glyphs=ab max=3 default=ba").default_value == U"ba");
    CHECK(text_input("glyphs=ab max=3").default_value.empty());
}

TEST_CASE("what is wrong with a text is told at its place")
{
    CHECK(findings("input t kind=text max=3") ==
          "3:1 error: input needs the property \"glyphs\" (add glyphs=…)");
    CHECK(findings("input t kind=text glyphs=a") ==
          "3:1 error: input needs the property \"max\" (add max=…)");
    CHECK(findings("input t kind=txt") == "3:14 error: unknown value \"txt\" (did you mean \"text\"?)");
    CHECK(findings("input t kind=text glyphs=\"\" max=3") ==
          "3:26 error: this input has no characters (write those that it may have, as in \"0-9:%\")");
    CHECK(findings("input t kind=text glyphs=\"x9-0\" max=3")
              .starts_with("3:28 error: this range runs backwards"));
    CHECK(findings("input t kind=text glyphs=\"a\\nb\" max=3")
              .starts_with("3:26 error: a text is one line of visible characters"));
    CHECK(findings("input t kind=text glyphs=\"!-香\" max=3")
              .starts_with("3:27 error: a text has at most 255 different characters, the space among them"));
    CHECK(findings("input t kind=text glyphs=ab max=61")
              .starts_with("3:33 error: this number is out of range"));
    CHECK(
        findings("input t kind=text glyphs=ab max=0").starts_with("3:33 error: this number is out of range"));
    CHECK(findings("input t kind=text glyphs=ab max=3 default=axb") ==
          "3:44 error: this input has no \"x\" (U+0078) (add it to glyphs=)");
    CHECK(findings("input t kind=text glyphs=ab max=3 default=abab") ==
          "3:43 error: this text has 4 characters (allowed: up to 3, by max=)");
    CHECK(
        findings("input t kind=text glyphs=ab max=3 min=0").starts_with("3:35 error: input has no property"));
}

TEST_CASE("a label has the letters of its font, in their size")
{
    const scene::Label sans = label("at=\"9,40.5\" size=32 font=hershey-sans align=right spacing=-1.5");
    CHECK(sans.input == 0);
    CHECK(sans.at == scene::Point{144, 648});
    CHECK(sans.align == Align::right);
    CHECK(sans.spacing == -1.5 * kfb::advance_one);
    REQUIRE(sans.glyphs.size() == 2);
    CHECK(sans.glyphs[0].drawing.strokes.empty());
    CHECK(sans.glyphs[1].advance == 8 * kfb::advance_one);
    CHECK(text_of(sans.glyphs[1].drawing) == "M 4 -21 L 4 0");
    CHECK(sans.kerning.empty());
    CHECK(label("at=\"9,40\" size=32 font=hershey-sans vertical=middle").at == scene::Point{144, 808});
    CHECK(label("at=\"9,40\" size=32 font=hershey-sans vertical=top").at == scene::Point{144, 976});
    CHECK(text_of(label("at=\"0,0\" size=32 font=hershey-serif").glyphs[1].drawing) ==
          "M 5 -21 L 5 0 M 6 -21 L 6 0 M 2 -21 L 9 -21 M 2 0 L 9 0");
}

TEST_CASE("a label turns about its place")
{
    CHECK(items_read(std::string{plain} +
                     "\nobject o stroke=red rotate=90 { text input=t at=\"9,7\" size=20 font=hershey-sans }")
              .find("pivot_x[144] pivot_y[112]") != std::string::npos);
    CHECK(
        items_read(
            std::string{plain} +
            "\nobject o stroke=red rotate=90 pivot-x=1 { text input=t at=\"9,7\" size=20 font=hershey-sans }")
            .find("pivot_x[16] pivot_y[112]") != std::string::npos);
    CHECK(items_read(std::string{plain} + "\nobject o stroke=red rotate=90 { text input=t at=\"9,7\" size=20 "
                                          "font=hershey-sans vertical=middle }")
              .find("pivot_x[144] pivot_y[112]") != std::string::npos);
}

TEST_CASE("a label stands alone in an object, without carriers")
{
    CHECK(findings(plain).empty());
    CHECK(findings(plain, "text input=t at=\"9,9\" size=32 font=hershey-sans; key 0 x=1; key 9 x=2; track y "
                          "{ at 0 1; at 2 3 }")
              .empty());
    const std::string alone = "error: the text of an input is all that an object draws, and not in a key";
    for (const char* text : {"circle 1 1 r=2; text input=t at=\"9,9\" size=32 font=hershey-sans",
                             "key 0 { text input=t at=\"9,9\" size=32 font=hershey-sans }",
                             "text input=t at=\"9,9\" size=32 font=hershey-sans; text input=t at=\"9,30\" "
                             "size=32 font=hershey-sans"})
        CHECK(findings(plain, text).find(alone) != std::string::npos);
    CHECK(read_on_canvas(std::string{plain} + "\nsymbol s { text input=t at=\"9,9\" size=32 "
                                              "font=hershey-sans }\nobject o stroke=red { use s 1 2 }")
              .findings.find(alone) != std::string::npos);
    CHECK(findings(plain, "text input=t at=\"9,9\" size=32 font=hershey-sans", "bone=x")
              .find("the text of an input has no bone") != std::string::npos);
    CHECK(findings(plain, "text input=t at=\"9,9\" size=32 font=hershey-sans; weights auto")
              .find("the text of an input has no weights") != std::string::npos);
    CHECK(findings(plain, "text input=t at=\"9,9\" size=32 font=hershey-sans; key 0 { skeleton { backbone 1 "
                          "1 2 2; width 3 } }")
              .find("the text of an input has no skeleton") != std::string::npos);
}

TEST_CASE("what is wrong with a label is told at its place")
{
    CHECK(findings(plain, "text input=q at=\"9,9\" size=32 font=hershey-sans")
              .find("5:12 error: unknown input \"q\"") != std::string::npos);
    CHECK(findings("", "text input=q at=\"9,9\" size=32 font=hershey-sans") ==
          "5:12 error: unknown input \"q\" (add \"input q kind=text glyphs=A-Z max=8\" to the scene)");
    CHECK(findings("input n kind=drawing points=2", "text input=n at=\"9,9\" size=32 font=hershey-sans")
              .starts_with("5:12 error: the input \"n\" is a drawing, not a text"));
    CHECK(findings(plain, "text words input=t at=\"9,9\" size=32 font=hershey-sans")
              .find("5:6 error: this value is too many") != std::string::npos);
    CHECK(findings(plain, "text input=t size=32").find("5:1 error: text needs the property \"at\"") !=
          std::string::npos);
    CHECK(findings(plain, "text input=t at=\"9,9\" size=32 font=hershey-sans leading=3")
              .find("5:49 error: text has no property \"leading\"") != std::string::npos);
    CHECK(findings("input t kind=text glyphs=\"aé\" max=3")
              .starts_with("5:31 error: the font \"hershey-sans\" has no \"é\" (U+00E9), which the input "
                           "\"t\" may have"));
    CHECK(findings("input t kind=text glyphs=W max=60", "text input=t at=\"9,9\" size=200 font=hershey-sans")
              .starts_with("5:1 error: a text of 60 characters may be more than 4095 px wide here"));
    CHECK(findings(plain, "text input=t at=\"9,9\" size=4094 font=hershey-sans")
              .find("a letter of this text is more than 2047 px large") != std::string::npos);
    CHECK(findings(plain, "track x input=t { at 0 1 }; rect 1 1 2 2")
              .find("the input \"t\" is a text, not a number") != std::string::npos);
    CHECK(findings(plain, "rect 1 1 2 2").starts_with("3:1 warning: the input \"t\" shows nothing"));
}

}
