#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

// In hershey-sans, which these texts name, an I is one line, 4 units from the left of a letter of 8; a text
// of size 32 has 1 px a unit. The capitals are 21 units high.

TEST_CASE("a text begins at the left end of its baseline")
{
    CHECK(drawn("text I at=\"50,60\" size=32 font=hershey-sans") == "M 54 39 L 54 60");
    CHECK(drawn("text I at=\"50,60\" size=64 font=hershey-sans") == "M 58 18 L 58 60");
    CHECK(drawn("text I at=\" 50 60 \" size=8 font=hershey-sans") == "M 51 54.75 L 51 60");
    CHECK(drawn("text I at=\"-50,-6e1\" size=32 font=hershey-sans") == "M -46 -81 L -46 -60");
}

TEST_CASE("letters are strokes in the order of the text")
{
    CHECK(drawn("text HI at=\"10,20\" size=32 font=hershey-sans") ==
          "M 14 -1 L 14 20 M 28 -1 L 28 20 M 14 9 L 28 9 M 36 -1 L 36 20");
    CHECK(drawn("text \"I I\" at=\"0,0\" size=32 font=hershey-sans") == "M 4 -21 L 4 0 M 28 -21 L 28 0");
}

TEST_CASE("spacing is added between letters, not around them")
{
    CHECK(drawn("text II at=\"50,50\" size=32 font=hershey-sans spacing=2") ==
          "M 54 29 L 54 50 M 64 29 L 64 50");
    CHECK(drawn("text II at=\"50,50\" size=32 font=hershey-sans spacing=-8.5") ==
          "M 54 29 L 54 50 M 53.5 29 L 53.5 50");
    CHECK(drawn("text II at=\"50,50\" size=32 font=hershey-sans spacing=2 align=right") ==
          "M 36 29 L 36 50 M 46 29 L 46 50");
}

TEST_CASE("each line of a text is aligned by itself")
{
    const std::string lines = "text \"I\\nII\" at=\"50,50\" size=32 font=hershey-sans leading=40 align=";
    CHECK(drawn(lines + "left") == "M 54 29 L 54 50 M 54 69 L 54 90 M 62 69 L 62 90");
    CHECK(drawn(lines + "center") == "M 50 29 L 50 50 M 46 69 L 46 90 M 54 69 L 54 90");
    CHECK(drawn(lines + "right") == "M 46 29 L 46 50 M 38 69 L 38 90 M 46 69 L 46 90");
}

TEST_CASE("lines are 1.2 sizes apart unless leading says otherwise")
{
    CHECK(drawn("text \"I\\n\\nI\" at=\"50,50\" size=40 font=hershey-sans") ==
          "M 55 23.75 L 55 50 M 55 119.75 L 55 146");
    CHECK(drawn("text \"I\\nI\" at=\"50,50\" size=32 font=hershey-sans leading=0") ==
          "M 54 29 L 54 50 M 54 29 L 54 50");
    CHECK(drawn("text \"\"\"\n  I\n  I\n  \"\"\" at=\"50,50\" size=32 font=hershey-sans leading=10") ==
          "M 54 29 L 54 50 M 54 39 L 54 60");
}

TEST_CASE("a text lies at, above, below or around the height of its place")
{
    // Capitals of size 32 are 21 px high.
    const auto lines = [](const std::string& text, const std::string& vertical) {
        return drawn("text \"" + text +
                     "\" at=\"46,50\" size=32 font=hershey-sans leading=40 vertical=" + vertical);
    };
    CHECK(lines("I", "baseline") == "M 50 29 L 50 50");
    CHECK(lines("I", "top") == "M 50 50 L 50 71");
    CHECK(lines("I", "middle") == "M 50 39.5 L 50 60.5");
    CHECK(lines("I", "bottom") == "M 50 29 L 50 50");
    CHECK(lines("I\\nI", "baseline") == "M 50 29 L 50 50 M 50 69 L 50 90");
    CHECK(lines("I\\nI", "top") == "M 50 50 L 50 71 M 50 90 L 50 111");
    CHECK(lines("I\\nI", "middle") == "M 50 19.5 L 50 40.5 M 50 59.5 L 50 80.5");
    CHECK(lines("I\\nI", "bottom") == "M 50 -11 L 50 10 M 50 29 L 50 50");
    CHECK(lines("I", "center") ==
          "1:67 error: unknown value \"center\" (allowed: baseline, top, middle, bottom)");
}

TEST_CASE("letters stand on a path, each in the direction that it has in the middle of the letter")
{
    const auto along = [](const std::string& path, const std::string& rest = "",
                          const std::string& text = "II") {
        return drawn("text " + text + " along=\"" + path + "\" size=32 font=hershey-sans " + rest);
    };
    CHECK(along("M 10 50 L 90 50") == "M 14 29 L 14 50 M 22 29 L 22 50");
    CHECK(along("M 10 50 L 90 50", "start=0.5") == "M 54 29 L 54 50 M 62 29 L 62 50");
    CHECK(along("M 10 50 L 90 50", "start=0.5 align=center") == "M 46 29 L 46 50 M 54 29 L 54 50");
    CHECK(along("M 10 50 L 90 50", "start=1 align=right spacing=2") == "M 76 29 L 76 50 M 86 29 L 86 50");
    CHECK(along("M 90 50 L 10 50") == "M 86 71 L 86 50 M 78 71 L 78 50");
    CHECK(along("M 50 10 L 50 90") == "M 71 14 L 50 14 M 71 22 L 50 22");
    CHECK(along("M 10 50 L 18 50 L 18 90") == "M 14 29 L 14 50 M 39 54 L 18 54");
    CHECK(along("M 10 50 L 50 50 L 50 90 L 10 90 Z", "start=0.9") == "M -11 62 L 10 62 M -11 54 L 10 54");
    CHECK(along("M 10 50 L 50 50 L 50 90 L 10 90 Z", "align=center") == "M -11 54 L 10 54 M 14 29 L 14 50");
}

TEST_CASE("along a curve, letters are as far apart as their advances")
{
    const std::string circle = "text IIII along=\"M 50 10 A 40 40 0 0 1 90 50\" size=32 font=hershey-sans";
    const std::string strokes = drawn(circle);
    CHECK(strokes.starts_with("M 56.0625 -10.6875 L 54 10.1875")); // 4 / 40 radians behind noon
}

TEST_CASE("what is wrong with a text along a path is told at its place")
{
    const auto along = [](const std::string& text) {
        return drawn("text " + text + " size=32 font=hershey-sans");
    };
    CHECK(along("II along=\"M 1 1\"").find("this path leads nowhere") != std::string::npos);
    CHECK(
        along("II along=\"M 1 1 L 90 9 M 2 2 L 30 9\"") ==
        "1:15 error: a text follows one stroke; this path has 2 (leave out all M but the first, and what is "
        "behind Z)");
    CHECK(along("\"I\\nI\" along=\"M 1 1 L 90 9\"") ==
          "1:6 error: a text along a path has one line (write a text for each line, along paths beside each "
          "other)");
    CHECK(along("II along=\"M 10 50 L 22 50\"")
              .find("1:6 warning: 4 pixels of this text lie beyond its path") != std::string::npos);
    CHECK(along("II along=\"M 10 50 L 90 50\" at=\"1,2\"") ==
          "1:33 error: along=… says where this text is, in the place of at (remove at=… or along=…)");
    CHECK(along("II along=\"M 10 50 L 90 50\" vertical=top")
              .starts_with("1:33 error: a text along a path stands on it, and is not moved across it"));
    CHECK(along("II along=\"M 10 50 L 90 50\" leading=9")
              .starts_with("1:33 error: a text along a path has one line"));
    CHECK(along("II along=\"M 10 50 L 90 50\" start=1.5").find("out of range") != std::string::npos);
}

TEST_CASE("a text may be of any bundled font")
{
    CHECK(drawn("text I at=\"50,60\" size=32 font=hershey-sans") == "M 54 39 L 54 60");
    CHECK(drawn("text I at=\"50,60\" size=32 font=hershey-serif") ==
          "M 55 39 L 55 60 M 56 39 L 56 60 M 52 39 L 59 39 M 52 60 L 59 60");
}

TEST_CASE("a text that draws nothing gets a warning")
{
    CHECK(drawn("text \"\" at=\"1,2\" size=3") == "1:6 warning: this text draws nothing");
    CHECK(drawn("text \" \\n \" at=\"1,2\" size=3") == "1:6 warning: this text draws nothing");
}

TEST_CASE("the default font is filled, and has the letters of Latin-1")
{
    // I: 201 to 403 units wide and 1493 high, of 2048.
    CHECK(drawn("text I at=\"0,0\" size=128") ==
          "M 12.5625 -93.3125 L 25.1875 -93.3125 L 25.1875 0 L 12.5625 0 L 12.5625 -93.3125");
    CHECK(drawn("text I at=\"0,0\" size=128") == drawn("text I at=\"0,0\" size=128 font=dejavu-sans"));
    for (const char* const font : {"dejavu-sans", "dejavu-sans-bold", "dejavu-sans-mono"})
        CHECK(drawn("text \"21° µ äöüß ÄÖÜ éèêñçå ×÷ ½ ÿ\" at=\"0,0\" size=9 font=" + std::string{font})
                  .starts_with("M "));
    CHECK(drawn("text I at=\"0,0\" size=128 font=dejavu-sans-bold") != drawn("text I at=\"0,0\" size=128"));
}

TEST_CASE("a character that the font lacks is named at its place, with the fonts that have it")
{
    const std::string filled = " (write font=dejavu-sans, dejavu-sans-bold or dejavu-sans-mono)";
    const std::string none = " (no bundled font has it: name a font file beside the scene)";
    CHECK(drawn("text \"Hä!\" at=\"1,2\" size=3 font=hershey-sans") ==
          "1:8 error: the font \"hershey-sans\" has no \"ä\" (U+00E4)" + filled);
    CHECK(drawn("text \"H\\tI\" at=\"1,2\" size=3 font=hershey-script") ==
          "1:6 error: the font \"hershey-script\" has no \"    \" (U+0009)" + none);
    CHECK(drawn("text \"日\" at=\"1,2\" size=3") ==
          "1:7 error: the font \"dejavu-sans\" has no \"日\" (U+65E5)" + none);
    CHECK(drawn("text \" ~\" at=\"1,2\" size=3 font=hershey-sans").find("error") == std::string::npos);
}

TEST_CASE("letters that are lines need a stroke to be seen")
{
    const auto findings = [](const std::string& text) { return read_on_canvas(text).findings; };
    const std::string warning =
        " warning: the letters of hershey-sans are lines, which a fill does not show, "
        "and there is no stroke (give the object a stroke=COLOUR, or the text "
        "font=dejavu-sans)";
    const std::string text = "text I at=\"1,2\" size=3 font=hershey-sans";
    CHECK(findings("object o fill=red { " + text + " }") == "3:26" + warning);
    CHECK(findings("object o fill=red { key 0 { " + text + " }; key 9 { " + text + " } }") ==
          "3:34" + warning);
    CHECK(
        findings("input t kind=text glyphs=\"0-9\" max=3\nobject o fill=red { text input=t at=\"1,9\" size=3 "
                 "font=hershey-sans }") == "4:21" + warning);
    CHECK(findings("symbol s { " + text + " }\nobject o fill=red { use s }\nobject p stroke=red { use s }") ==
          "4:25" + warning);
    CHECK(findings("object p stroke=red { " + text + " }\nobject o fill=red { circle 9 9 r=1 }") == "");
    CHECK(findings("object o fill=red { text I at=\"1,2\" size=3 }") == "");
}

TEST_CASE("unknown fonts are reported with those that there are")
{
    const std::string file = " (a font file beside the scene is named as \"Sans.ttf\"))";
    CHECK(drawn("text I at=\"1,2\" size=3 font=hershy-sans") ==
          "1:29 error: unknown font \"hershy-sans\" (did you mean \"hershey-sans\"?" + file);
    CHECK(drawn("text I at=\"1,2\" size=3 font=Arial") ==
          "1:29 error: unknown font \"Arial\" (allowed: dejavu-sans, dejavu-sans-bold, dejavu-sans-mono, "
          "hershey-sans, hershey-sans-medium, hershey-serif, hershey-serif-italic, hershey-script, "
          "hershey-gothic" +
              file);
    CHECK(drawn("text I at=\"1,2\" size=3 font=\"\"").starts_with("1:29 error: unknown font \"\""));
}

TEST_CASE("texts of another form are refused")
{
    CHECK(drawn("text at=\"1,2\" size=3") ==
          "1:1 error: text needs more values (write text \"WORDS\" at=\"X,Y\" size=PIXELS font=FONT)");
    CHECK(drawn("text 5 at=\"1,2\" size=3") == "1:6 error: a word or a text in quotes is expected here");
    CHECK(drawn("text I") == "1:1 error: text needs the property \"at\" (add at=…)\n"
                             "1:1 error: text needs the property \"size\" (add size=…)");
    for (const char* const at : {"10", "", "1,2,3", "1,,2", "x,y", "1 2 px", ",1"})
        CHECK(drawn("text I size=3 at=\"" + std::string{at} + '"') ==
              "1:18 error: a place \"X,Y\" is expected here (write \"20,200\")");
    CHECK(drawn("text I at=\"10,2048\" size=3") ==
          "1:11 error: this number is out of range (allowed: -2047 to 2047)");
    CHECK(drawn("text I at=\"1,2\" size=0") ==
          "1:22 error: this number is out of range (allowed: 0.0625 to 4094)");
    CHECK(drawn("text I at=\"1,2\" size=3 leading=-1") ==
          "1:32 error: this number is out of range (allowed: 0 to 4094)");
    CHECK(drawn("text I at=\"1,2\" size=3 align=middle") ==
          "1:30 error: unknown value \"middle\" (KFAST calls it \"center\")");
    CHECK(drawn("text I at=\"1,2\" size=3 colour=red") ==
          "1:24 error: text has no property \"colour\" (objects have it: object NAME fill=…)");
}

TEST_CASE("a text must stay on paper, and within the points of a drawing")
{
    CHECK(drawn("text I at=\"2040,2\" size=64 font=hershey-sans") ==
          "1:1 error: this text reaches more than 2047 px from the origin");
    const std::string letters(65'535 / 2, 'I');
    const auto text = [](const std::string& words) {
        return "text \"" + words + "\" at=\"0,30\" size=1 font=hershey-sans spacing=-0.25";
    };
    CHECK(drawn(text(letters)).find("error") == std::string::npos);
    CHECK(drawn(text(letters + 'I')) == "1:6 error: a drawing holds at most 65535 points");
    CHECK(drawn("line 1 2 3 4 5 6\n" + text(letters.substr(1))).find("error") == std::string::npos);
    CHECK(drawn("line 1 2 3 4\n" + text(letters)) == "2:6 error: a drawing holds at most 65535 points");
}

TEST_CASE("the strokes of a letter are marked as one")
{
    const SceneText read =
        read_on_canvas("object o fill=red { key 0 match=letters { text \"BOB\" at=\"5,60\" "
                       "size=30; circle 9 9 r=4 }; key 9 { empty } }");
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    CHECK(key_at(*read.scene).drawing.strokes.size() == 9);
    CHECK(key_at(*read.scene).letters == std::vector<std::size_t>{0, 3, 5, 8});
}

}
