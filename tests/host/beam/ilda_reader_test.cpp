#include "host/beam/ilda_reader.hpp"
#include "host/beam/ilda_writer.hpp"

#include <doctest/doctest.h>
#include <stdexcept>
#include <string>
#include <vector>

using namespace kfast;

namespace {

using Bytes = std::vector<std::byte>;

/// Two frames in format 5: a header of 32 bytes, two points of 8, a header, one point, the closing header.
Bytes file()
{
    const std::vector<BeamPoints> frames{{{{10, 20}, {9, 8, 7}}, {{-30, 40}, {.opacity = 0}}},
                                         {{{50, -60}, {1, 2, 3}}}};
    return ilda_file("x", IldaFormat::true_colour_2d, frames);
}

constexpr std::size_t second = 32 + 2 * 8;
constexpr std::size_t closing = second + 32 + 8;

std::string failure(const Bytes& bytes)
{
    try {
        read_ilda(bytes);
    } catch (const std::invalid_argument& reason) {
        return reason.what();
    }
    return {};
}

std::string failure_with(std::size_t place, int value)
{
    Bytes bytes = file();
    bytes[place] = static_cast<std::byte>(value);
    return failure(bytes);
}

std::string failure_of_length(std::size_t bytes)
{
    Bytes part = file();
    part.resize(bytes);
    return failure(part);
}

}

TEST_CASE("a proper file has nothing to be told")
{
    CHECK(failure(file()) == "");
    CHECK(file().size() == closing + 32);
}

TEST_CASE("what is reserved may be anything, and so may names, numbers and the projector")
{
    for (const std::size_t place : {4u, 5u, 6u, 8u, 16u, 26u, 29u, 30u, 31u})
        CHECK(failure_with(place, 0xFF) == "");
}

TEST_CASE("mistakes are told with their place")
{
    CHECK(failure_with(0, 'i') == "at byte 0: no section begins here, with ILDA");
    CHECK(failure_with(second + 3, 'B') == "at byte 48: no section begins here, with ILDA");
    CHECK(failure_with(7, 3) == "at byte 7: format 3 is none of 0, 1, 2, 4 and 5");
    CHECK(failure_with(second + 7, 6) == "at byte 55: format 6 is none of 0, 1, 2, 4 and 5");
    CHECK(failure_with(32 + 4, 0x80) ==
          "at byte 36: a point is told to be the last of the frame, but is not");
    CHECK(failure_with(32 + 8 + 4, 0x40) == "at byte 44: the last point of the frame is not told to be it");
}

TEST_CASE("a file that breaks off says where")
{
    CHECK(failure_of_length(0) == "at byte 0: the closing section is missing");
    CHECK(failure_of_length(31) == "at byte 31: the file breaks off in the header of a section");
    CHECK(failure_of_length(47) ==
          "at byte 47: the file breaks off: the section at byte 0 has 16 bytes of records");
    CHECK(failure_of_length(closing) == "at byte 88: the closing section is missing");
    CHECK(failure_of_length(closing + 33) == "at byte 120: 1 byte behind the closing section");
    for (std::size_t bytes = 0; bytes < closing + 32; ++bytes)
        CHECK(failure_of_length(bytes) != "");
}

TEST_CASE("a file without frames is none")
{
    const Bytes bytes = file();
    CHECK(failure({bytes.begin() + closing, bytes.end()}) == "at byte 32: there is no frame");
}

TEST_CASE("indices must be in the palette, but where the beam is dark")
{
    const std::vector<BeamPoints> frames{{{{1, 2}, {0, 255, 0}}, {{3, 4}, {.opacity = 0}}}};
    Bytes bytes = ilda_file("x", IldaFormat::indexed_2d, frames);
    bytes[32 + 6 + 5] = std::byte{64};
    CHECK(failure(bytes) == "");
    bytes[32 + 5] = std::byte{64};
    CHECK(failure(bytes) == "at byte 37: colour 64 is not among the 64 of the palette");
    bytes[32 + 5] = std::byte{63};
    CHECK(read_ilda(bytes).frames[0].points[0].point.colour == Colour{255, 32, 32});
}

TEST_CASE("a palette counts for the frames behind it")
{
    const std::vector<BeamPoints> frames{{{{1, 2}, {1, 2, 3}}}};
    Bytes bytes = ilda_file("x", IldaFormat::indexed_2d, frames);
    CHECK(read_ilda(bytes).frames[0].points[0].point.colour == Colour{1, 2, 3});
    bytes[32 + 64 * 3 + 1] = std::byte{99}; // green of colour 64
    CHECK(read_ilda(bytes).frames[0].points[0].point.colour == Colour{1, 99, 3});
    bytes[24] = std::byte{2}; // 577 colours
    bytes.resize(bytes.size() + 600 * 3);
    CHECK(failure(bytes) == "at byte 0: a palette of 577 colours: an index tells 256");
}

TEST_CASE("depth is read")
{
    const std::vector<BeamPoints> frames{{{{1, 2}, {1, 2, 3}}}};
    Bytes bytes = ilda_file("x", IldaFormat::true_colour_3d, frames);
    bytes[32 + 4] = std::byte{0xFF};
    bytes[32 + 5] = std::byte{0xFE};
    CHECK(read_ilda(bytes).frames[0].points[0].z == -2);
}

TEST_CASE("what a file amounts to")
{
    const IldaFacts facts = ilda_facts(read_ilda(file()));
    CHECK(facts.formats == std::set{IldaFormat::true_colour_2d});
    CHECK(facts.points == 3);
    CHECK(facts.lit_points == 2);
    CHECK(facts.max_points == 2);
    CHECK(facts.min == FieldPoint{-30, -60});
    CHECK(facts.max == FieldPoint{50, 40});
    CHECK(facts.longest_lit_step == 0);
    CHECK(facts.longest_blanked_step == doctest::Approx(44.72).epsilon(0.001));
}
