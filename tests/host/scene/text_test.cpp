#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

// In hershey-sans an I is one line, 4 units from the left of a letter of 8; a text of size 32 has 1 px a
// unit. The capitals are 21 units high.

TEST_CASE("a text begins at the left end of its baseline")
{
    CHECK(drawn("text I at=\"50,60\" size=32") == "M 54 39 L 54 60");
    CHECK(drawn("text I at=\"50,60\" size=64") == "M 58 18 L 58 60");
    CHECK(drawn("text I at=\" 50 60 \" size=8") == "M 51 54.75 L 51 60");
    CHECK(drawn("text I at=\"-50,-6e1\" size=32") == "M -46 -81 L -46 -60");
}

TEST_CASE("letters are strokes in the order of the text")
{
    CHECK(drawn("text HI at=\"10,20\" size=32") ==
          "M 14 -1 L 14 20 M 28 -1 L 28 20 M 14 9 L 28 9 M 36 -1 L 36 20");
    CHECK(drawn("text \"I I\" at=\"0,0\" size=32") == "M 4 -21 L 4 0 M 28 -21 L 28 0");
}

TEST_CASE("spacing is added between letters, not around them")
{
    CHECK(drawn("text II at=\"50,50\" size=32 spacing=2") == "M 54 29 L 54 50 M 64 29 L 64 50");
    CHECK(drawn("text II at=\"50,50\" size=32 spacing=-8.5") == "M 54 29 L 54 50 M 53.5 29 L 53.5 50");
    CHECK(drawn("text II at=\"50,50\" size=32 spacing=2 align=right") == "M 36 29 L 36 50 M 46 29 L 46 50");
}

TEST_CASE("each line of a text is aligned by itself")
{
    const std::string lines = "text \"I\\nII\" at=\"50,50\" size=32 leading=40 align=";
    CHECK(drawn(lines + "left") == "M 54 29 L 54 50 M 54 69 L 54 90 M 62 69 L 62 90");
    CHECK(drawn(lines + "center") == "M 50 29 L 50 50 M 46 69 L 46 90 M 54 69 L 54 90");
    CHECK(drawn(lines + "right") == "M 46 29 L 46 50 M 38 69 L 38 90 M 46 69 L 46 90");
}

TEST_CASE("lines are 1.2 sizes apart unless leading says otherwise")
{
    CHECK(drawn("text \"I\\n\\nI\" at=\"50,50\" size=40") == "M 55 23.75 L 55 50 M 55 119.75 L 55 146");
    CHECK(drawn("text \"I\\nI\" at=\"50,50\" size=32 leading=0") == "M 54 29 L 54 50 M 54 29 L 54 50");
    CHECK(drawn("text \"\"\"\n  I\n  I\n  \"\"\" at=\"50,50\" size=32 leading=10") ==
          "M 54 29 L 54 50 M 54 39 L 54 60");
}

TEST_CASE("a text may be of any bundled font")
{
    CHECK(drawn("text I at=\"50,60\" size=32 font=hershey-sans") == drawn("text I at=\"50,60\" size=32"));
    CHECK(drawn("text I at=\"50,60\" size=32 font=hershey-serif") ==
          "M 55 39 L 55 60 M 56 39 L 56 60 M 52 39 L 59 39 M 52 60 L 59 60");
}

TEST_CASE("a text that draws nothing gets a warning")
{
    CHECK(drawn("text \"\" at=\"1,2\" size=3") == "1:6 warning: this text draws nothing");
    CHECK(drawn("text \" \\n \" at=\"1,2\" size=3") == "1:6 warning: this text draws nothing");
}

TEST_CASE("a character that the font lacks is named at its place")
{
    const std::string remedy = " (it has those of ASCII; name a font file for others)";
    CHECK(drawn("text \"Hä!\" at=\"1,2\" size=3") ==
          "1:8 error: the font \"hershey-sans\" has no \"ä\" (U+00E4)" + remedy);
    CHECK(drawn("text \"H\\tI\" at=\"1,2\" size=3 font=hershey-script") ==
          "1:6 error: the font \"hershey-script\" has no \"    \" (U+0009)" + remedy);
    CHECK(drawn("text \"\\u{7f}\" at=\"1,2\" size=3") ==
          "1:6 error: the font \"hershey-sans\" has no \"<U+007F>\" (U+007F)" + remedy);
    CHECK(drawn("text \" ~\" at=\"1,2\" size=3").find("error") == std::string::npos);
}

TEST_CASE("unknown fonts are reported with those that there are")
{
    const std::string file = " (a font file beside the scene is named as \"Sans.ttf\"))";
    CHECK(drawn("text I at=\"1,2\" size=3 font=hershy-sans") ==
          "1:29 error: unknown font \"hershy-sans\" (did you mean \"hershey-sans\"?" + file);
    CHECK(drawn("text I at=\"1,2\" size=3 font=Arial") ==
          "1:29 error: unknown font \"Arial\" (allowed: hershey-sans, hershey-sans-medium, hershey-serif, "
          "hershey-serif-italic, hershey-script, hershey-gothic" +
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
          "1:30 error: unknown value \"middle\" (allowed: left, center, right)");
    CHECK(drawn("text I at=\"1,2\" size=3 colour=red") ==
          "1:24 error: text has no property \"colour\" (allowed: at, size, font, align, spacing, leading)");
}

TEST_CASE("a text must stay on paper, and within the points of a drawing")
{
    CHECK(drawn("text I at=\"2040,2\" size=64") ==
          "1:1 error: this text reaches more than 2047 px from the origin");
    const std::string letters(65'535 / 2, 'I');
    const auto text = [](const std::string& words) {
        return "text \"" + words + "\" at=\"0,30\" size=1 spacing=-0.25";
    };
    CHECK(drawn(text(letters)).find("error") == std::string::npos);
    CHECK(drawn(text(letters + 'I')) == "1:6 error: a drawing holds at most 65535 points");
    CHECK(drawn("line 1 2 3 4 5 6\n" + text(letters.substr(1))).find("error") == std::string::npos);
    CHECK(drawn("line 1 2 3 4\n" + text(letters)) == "2:6 error: a drawing holds at most 65535 points");
}

}
