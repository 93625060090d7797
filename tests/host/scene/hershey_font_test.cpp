#include "host/scene/font/hershey_font.hpp"

#include "core/bytes/crc32.hpp"
#include "host/fonts/dejavu_faces.hpp"
#include "host/program/failure.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace kfast::test {
namespace {

std::uint32_t checksum(std::string_view text)
{
    Crc32 crc;
    crc.add(std::as_bytes(std::span{text}));
    return crc.value();
}

const scene::HersheyFace& face(std::string_view name)
{
    return *std::ranges::find(scene::hershey_faces(), name, &scene::HersheyFace::name);
}

struct Known {
    std::string_view name;
    std::uint32_t checksum;
};

constexpr std::array known{
    Known{"hershey-sans", 0x5709517F},   Known{"hershey-sans-medium", 0x8A14FA7E},
    Known{"hershey-serif", 0xD5AC372F},  Known{"hershey-serif-italic", 0x503962F5},
    Known{"hershey-script", 0x7724B93B}, Known{"hershey-gothic", 0xF528FCF6},
};

/// Letters 'space' to `last` that draw nothing, then the glyph of the next character.
std::string font_with(const std::string& glyph) { return "12345  1JZ\n" + glyph; }

/// The strokes of !, the second character.
std::string strokes(const std::string& glyph)
{
    scene::HersheyFont font{font_with(glyph)};
    const scene::Letter* const letter = font.letter(U'!');
    REQUIRE(letter != nullptr);
    std::string text = std::to_string(static_cast<int>(letter->advance)) + ':';
    const auto add = [&](const char* mark, scene::Vec2 spot) {
        text +=
            mark + std::to_string(static_cast<int>(spot.x)) + ',' + std::to_string(static_cast<int>(spot.y));
    };
    for (const scene::Outline& outline : letter->outlines) {
        add(" M", outline.from);
        for (const scene::Curve& curve : outline.curves)
            add(" L", curve.to);
    }
    return text;
}

}

TEST_CASE("the bundled letters are those that scenes were made with")
{
    REQUIRE(scene::hershey_faces().size() == known.size());
    for (const Known& expected : known) {
        CAPTURE(expected.name);
        CHECK_MESSAGE(checksum(face(expected.name).jhf) == expected.checksum,
                      "the package hershey-fonts-data has other letters now: texts of scenes will look "
                      "different. If that is wanted, write the new checksum here and say so in CHANGELOG.md");
    }
}

TEST_CASE("the filled letters are those that scenes were made with")
{
    const auto same = [](std::string_view file, std::uint32_t expected) {
        return checksum(file) == expected;
    };
    const auto changed =
        "the package fonts-dejavu-core has other letters now: texts of scenes will look different. If "
        "that is wanted, write the new checksum here and say so in CHANGELOG.md";
    CHECK_MESSAGE(same(dejavu_sans(), 0xD74C30B5), changed);
    CHECK_MESSAGE(same(dejavu_sans_bold(), 0xFD8FF11C), changed);
    CHECK_MESSAGE(same(dejavu_sans_mono(), 0xAF544837), changed);
}

TEST_CASE("all Hershey fonts have the characters of ASCII")
{
    for (const scene::HersheyFace& bundled : scene::hershey_faces()) {
        CAPTURE(bundled.name);
        scene::HersheyFont font{bundled.jhf};
        for (char32_t character = U' '; character <= U'~'; ++character) {
            const scene::Letter* const letter = font.letter(character);
            REQUIRE(letter != nullptr);
            CHECK(letter->outlines.empty() == (character == U' '));
            CHECK(letter->advance > 0);
        }
        CHECK(font.letter(U'\x1F') == nullptr);
        CHECK(font.letter(U'\x7F') == nullptr);
        CHECK(font.letter(U'ä') == nullptr);
    }
}

TEST_CASE("single-line fonts draw a stem once, the others twice")
{
    const auto stems = [](std::string_view name) {
        scene::HersheyFont font{face(name).jhf};
        return font.letter(U'1')->outlines.size();
    };
    CHECK(stems("hershey-sans") == 1);
    CHECK(stems("hershey-script") == 1);
    CHECK(stems("hershey-sans-medium") > 1);
    CHECK(stems("hershey-serif") > 1);
}

TEST_CASE("a glyph is pairs of letters around R, from its left end and its baseline")
{
    CHECK(strokes("    8  9MWOMOV RUMUV ROQUQ") == "10: M2,-14 L2,-5 M8,-14 L8,-5 M2,-10 L8,-10");
    CHECK(strokes("    8  9MWOMOV R\nUMUV RO\r\nQUQ\n") == "10: M2,-14 L2,-5 M8,-14 L8,-5 M2,-10 L8,-10");
    CHECK(strokes("    8  4MW RRR R") == "10: M5,-9");
    CHECK(strokes("    8  1MW") == "10:");
}

TEST_CASE("damaged fonts are refused")
{
    for (const char* const glyph : {"    8  9MWOMOV RUMUV ROQU", "    8  9", "    8  1M", "    8 x1MW",
                                    "    8   MW", "    8 -1MW", "x", "    8  0MWAB"})
        CHECK_THROWS_AS(scene::HersheyFont{font_with(glyph)}, Failure);
    CHECK(scene::HersheyFont{""}.letter(U' ') == nullptr);
}

}
