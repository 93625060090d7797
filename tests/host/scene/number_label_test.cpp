#include "tests/host/scene/scene_text.hpp"

#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

std::string scene_text(const std::string& properties, const std::string& range)
{
    return "input n " + range +
           "\nobject o stroke=red { text input=n at=\"9,40\" size=32 font=hershey-sans " + properties + " }";
}

scene::Label label(const std::string& properties, const std::string& range = "min=0 max=240")
{
    const SceneText read = read_on_canvas(scene_text(properties, range));
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    CHECK(read.findings.empty());
    return *object_at(*read.scene).label;
}

/// Prints "decimals digits places" and the glyphs in front of the number and behind it.
std::string format(const std::string& pattern)
{
    const scene::Label read = label("format=\"" + pattern + '"');
    const scene::NumberFormat& format = read.format.value();
    std::string text = std::to_string(format.decimals) + ' ' + std::to_string(format.digits) + ' ' +
                       std::to_string(format.places);
    for (const auto* glyphs : {&format.before, &format.behind}) {
        text += " |";
        for (const std::uint8_t glyph : *glyphs)
            text += ' ' + std::to_string(glyph);
    }
    return text;
}

std::string found_in(const std::string& properties, const std::string& range = "min=0 max=240")
{
    return read_on_canvas(scene_text(properties, range)).findings;
}

}

TEST_CASE("a format tells decimals, zeros, gaps, and what stands around the number")
{
    CHECK(format("#") == "0 1 0 | |");
    CHECK(format("###") == "0 1 0 | |");
    CHECK(format("##0") == "0 1 0 | |");
    CHECK(format("000") == "0 3 0 | |");
    CHECK(format("#00") == "0 2 0 | |");
    CHECK(format("__0") == "0 1 3 | |");
    CHECK(format("___") == "0 1 3 | |");
    CHECK(format("_00") == "0 2 3 | |");
    CHECK(format("###.#") == "1 1 0 | |");
    CHECK(format("0.000") == "3 1 0 | |");
    CHECK(format("0,00") == "2 1 0 | |");
    CHECK(format("# km/h") == "0 1 0 | | 13 14 15 16 17");
    CHECK(format("v=0 v") == "0 1 0 | 13 14 | 15 13");
    CHECK(format("0/100") == "0 1 0 | | 13 14 15 15");
    CHECK(format("0.") == "0 1 0 | | 13");
    CHECK(format("# of 1.05") == "0 1 0 | | 13 14 15 13 16 17 18 19");
    CHECK(!label("").format->decimals);
}

TEST_CASE("what stands between quotes is itself")
{
    CHECK(format("'#0' 0:'00'") == "0 1 0 | 13 14 15 | 16 14 14");
    CHECK(format("0'_'") == "0 1 0 | | 13");
    CHECK(format("#'") == "0 1 0 | | 13");
    CHECK(format("#''") == "0 1 0 | | 13");
    CHECK(format("'it''s' #") == "0 1 0 | 13 14 15 16 17 |");
}

TEST_CASE("a second number, and separators of thousands, are refused at their place")
{
    const std::string second =
        " error: a format has one number, and this is a digit of a second one (put what "
        "is shown as it is between quotes, as in \"#:'00'\")";
    CHECK(found_in("format=\"0:00\"") == "4:82" + second);
    CHECK(found_in("format=\"10x#\"") == "4:83" + second);
    CHECK(found_in("format=\"#.#.#\"") == "4:84" + second);
    CHECK(found_in("format=\"# µ_\"") == "4:83" + second);
    const std::string thousands =
        " error: there are no separators of thousands (write the digits together, as "
        "in \"###0\"; decimals are \"0.000\")";
    CHECK(found_in("format=\"#,##0\"") == "4:81" + thousands);
    CHECK(found_in("format=\"#.##0 m\"") == "4:81" + thousands);
    CHECK(found_in("format=\"#,###,##0\"") == "4:85" + thousands);
}

TEST_CASE("a label of a number has its digits, and what else it needs")
{
    const scene::Label whole = label("");
    REQUIRE(whole.glyphs.size() == kfb::number_glyph::first_other);
    CHECK(text_of(whole.glyphs[1].drawing) == text_of(label("format=\"0.0\"").glyphs[1].drawing));
    CHECK(whole.glyphs[kfb::number_glyph::minus].drawing.strokes.empty());
    CHECK(whole.glyphs[kfb::number_glyph::point].drawing.strokes.empty());
    CHECK(whole.glyphs[kfb::number_glyph::gap].drawing.strokes.empty());
    CHECK(whole.glyphs[kfb::number_glyph::gap].advance == whole.glyphs[0].advance);
    CHECK(whole.kerning.empty());
    CHECK(!label("", "min=-1 max=1").glyphs[kfb::number_glyph::minus].drawing.strokes.empty());
    CHECK(text_of(label("format=\"0.0\"").glyphs[kfb::number_glyph::point].drawing) !=
          text_of(label("format=\"0,0\"").glyphs[kfb::number_glyph::point].drawing));
}

TEST_CASE("what an input shows follows no path, and that is all that is told")
{
    const auto along = [](const std::string& input) {
        return read_on_canvas(input + "\nobject o fill=red { text input=n along=\"M 2 2 L 90 9\" size=9 }")
            .findings;
    };
    CHECK(along("input n min=0 max=9") ==
          "4:34 error: a number does not follow a path (write at=\"X,Y\" in the place of along=…)");
    CHECK(along("input n kind=text glyphs=\"0-9\" max=5")
              .starts_with("4:34 error: the text of an input does not follow a path"));
}

TEST_CASE("what is wrong with a format is told at its place")
{
    const std::string hint = " (write a digit as #, _ or 0, and what stands around it, as in \"##0.0 km/h\")";
    CHECK(found_in("format=\"km/h\"") == "4:79 error: this format has no digit" + hint);
    CHECK(found_in("format=\"\"") == "4:79 error: this format has no digit" + hint);
    CHECK(found_in("format=\"0#\"") == "4:79 error: # and _ stand in front of 0" + hint);
    CHECK(found_in("format=\"0.0000\"") ==
          "4:79 error: a number has at most 10 digits before the point and 3 behind it" + hint);
    CHECK(found_in("format=\"00000000000\"") ==
          "4:79 error: a number has at most 10 digits before the point and 3 behind it" + hint);
    CHECK(found_in("format=\"0" + std::string(46, 'x') + '"') ==
          "4:79 error: at most 45 characters stand around a number" + hint);
    CHECK(found_in("format=\"0\\nx\"") == "4:79 error: a format is one line of visible characters" + hint);
    CHECK(found_in("format=\"0 °C\"")
              .starts_with(
                  "4:54 error: the font \"hershey-sans\" has no \"°\" (U+00B0), which this number has"));
    CHECK(found_in("format=0", "kind=text glyphs=ab max=2") ==
          "4:72 error: only a number has a format (remove it, or let the input be a number)");
    CHECK(found_in("spacing=4000") ==
          "4:23 error: a text of 3 characters may be more than 4095 px wide here (lower size=)");
    CHECK(found_in("", "kind=drawing points=3 { line 1 1 2 2 }")
              .starts_with("4:34 error: the input \"n\" is a drawing, not a text"));
}

TEST_CASE("a number that only a label shows is used")
{
    CHECK(found_in("").empty());
    CHECK(read_on_canvas("input n\nobject o fill=red { rect 1 1 2 2 }")
              .findings.find("add input=n to a track, an item, a pose or a text") != std::string::npos);
}

}
