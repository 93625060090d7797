#include "host/beam/ilda_format.hpp"
#include "host/beam/ilda_reader.hpp"
#include "host/beam/ilda_writer.hpp"

#include <doctest/doctest.h>
#include <vector>

using namespace kfast;

namespace {

constexpr Colour green{0, 255, 0};
constexpr Colour odd{1, 2, 3}; ///< not among the default ones

/// The last but one is a blanked one.
const std::vector<BeamPoints> frames{
    {{{-32768, 32767}, green}, {{1, -2}, {.opacity = 0}}, {{0x1234, -0x1234}, {255, 255, 255}}},
    {{{0, 0}, odd}},
};

constexpr std::array formats{IldaFormat::indexed_3d, IldaFormat::indexed_2d, IldaFormat::true_colour_3d,
                             IldaFormat::true_colour_2d};

}

TEST_CASE("what is written is read back, point for point, in every format")
{
    for (const IldaFormat format : formats) {
        CAPTURE(static_cast<int>(format));
        const IldaContents contents = read_ilda(ilda_file("robot", format, frames));
        CHECK(contents.palettes == (is_indexed(format) ? 1 : 0));
        REQUIRE(contents.frames.size() == 2);
        for (std::size_t number = 0; number < frames.size(); ++number) {
            const IldaFrame& frame = contents.frames[number];
            CHECK(frame.format == format);
            CHECK(frame.name == "robot");
            CHECK(frame.company == "KFAST");
            CHECK(frame.number == number);
            CHECK(frame.frames == 2);
            REQUIRE(frame.points.size() == frames[number].size());
            for (std::size_t at = 0; at < frame.points.size(); ++at) {
                CHECK(frame.points[at].point == frames[number][at]);
                CHECK(frame.points[at].z == 0);
            }
        }
    }
}

TEST_CASE("colours of the default palette need no other one, and keep their numbers in one that is longer")
{
    const std::vector<BeamPoints> known{{{{0, 0}, green}}};
    CHECK(read_ilda(ilda_file("", IldaFormat::indexed_2d, known)).palettes == 0);
    IldaPalette palette;
    palette.add(frames[1]);
    CHECK(palette.index(green) == 24);
    CHECK(palette.index(odd) == 64);
    CHECK(palette.colours().size() == 65);
}

TEST_CASE("the default palette has the colours at the places that the specification names")
{
    const auto palette = default_ilda_palette();
    CHECK(palette[0] == Colour{255, 0, 0});
    CHECK(palette[16] == Colour{255, 255, 0});
    CHECK(palette[24] == Colour{0, 255, 0});
    CHECK(palette[31] == Colour{0, 255, 255});
    CHECK(palette[40] == Colour{0, 0, 255});
    CHECK(palette[48] == Colour{255, 0, 255});
    CHECK(palette[56] == Colour{255, 255, 255});
}

TEST_CASE("where there are more than 256 colours, the nearest one is taken")
{
    BeamPoints many;
    for (int level = 0; level < 256; ++level)
        many.push_back({{}, {static_cast<std::uint8_t>(level), 1, 1}});
    IldaPalette palette;
    palette.add(many);
    CHECK(palette.colours().size() == 256);
    CHECK(palette.is_too_small());
    CHECK_FALSE(IldaPalette{frames}.is_too_small());
    CHECK(palette.index({191, 1, 1}) == 255);
    CHECK(palette.index({201, 1, 1}) == 255);
    CHECK(palette.index({254, 1, 0}) == 0); // red
}

TEST_CASE("names have eight letters of ASCII")
{
    const auto name_of = [](std::string_view name) {
        return read_ilda(ilda_file(name, IldaFormat::true_colour_2d, frames)).frames[0].name;
    };
    CHECK(name_of("robot-eyes") == "robot-ey");
    CHECK(name_of("") == "");
    CHECK(name_of("a\x01\xC3\xA4") == "a___");
}
