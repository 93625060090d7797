#include "core/packed_drawing.hpp"

#include "host/compiler/model_reader.hpp"
#include "host/compiler/pack_drawing.hpp"

#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

scene::Point random_point(std::mt19937& random, int bits)
{
    const auto coordinate = [&random, bits] {
        return static_cast<std::int16_t>(static_cast<std::int32_t>(random()) >> (32 - bits));
    };
    const std::int16_t x = coordinate();
    return {x, coordinate()};
}

scene::Drawing random_drawing(std::mt19937& random)
{
    scene::Drawing drawing;
    drawing.strokes.resize(random() % 4);
    for (scene::Stroke& stroke : drawing.strokes) {
        const int bits = 2 + static_cast<int>(random() % 15);
        stroke.from = random_point(random, 16);
        for (auto left = random() % 6; left > 0; --left) {
            scene::Segment segment{
                .cubic = random() % 2 == 0, .c1 = {}, .c2 = {}, .to = random_point(random, bits)};
            if (segment.cubic) {
                segment.c1 = random_point(random, bits);
                segment.c2 = random_point(random, bits);
            }
            stroke.segments.push_back(segment);
        }
    }
    return drawing;
}

}

TEST_CASE("what is packed is read back, bit for bit, at every width")
{
    std::mt19937 random{51};
    for (int round = 0; round < 3000; ++round) {
        const scene::Drawing drawing = random_drawing(random);
        ByteWriter bytes;
        pack_drawing(drawing, bytes);
        PackedDrawing packed{ByteReader{bytes.bytes()}};
        ModelReader model{drawing};
        REQUIRE(packed.strokes() == model.strokes());
        for (std::uint32_t stroke = 0; stroke < packed.strokes(); ++stroke) {
            const std::uint32_t segments = packed.next_stroke();
            REQUIRE(segments == model.next_stroke());
            CHECK(packed.start() == model.start());
            for (std::uint32_t i = 0; i < segments; ++i) {
                Segment expected = model.next_segment();
                if (expected.kind == Segment::Kind::line)
                    expected.c1 = expected.c2 = {};
                CHECK(packed.next_segment() == expected);
            }
        }
        CHECK(packed.is_sound());
    }
}

TEST_CASE("small drawings take few bytes")
{
    scene::Drawing square{{{{160, 160}, {}}}};
    for (const auto& [x, y] : {std::pair{480, 160}, {480, 480}, {160, 480}, {160, 160}})
        square.strokes[0].segments.push_back(
            {.cubic = false,
             .c1 = {},
             .c2 = {},
             .to = {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)}});
    ByteWriter bytes;
    pack_drawing(square, bytes);
    CHECK(bytes.size() == 1 + 1 + 1 + 4 + 10); // strokes, head, segments, start, 8 differences of 10 bits
}

TEST_CASE("a drawing that is cut, too wide or outside of 16 bits is not sound")
{
    const auto is_sound = [](std::vector<int> values) {
        std::vector<std::byte> bytes;
        for (const int value : values)
            bytes.push_back(static_cast<std::byte>(value));
        PackedDrawing drawing{ByteReader{bytes}};
        for (std::uint32_t segments = drawing.next_stroke(); segments > 0; --segments)
            drawing.next_segment();
        return drawing.is_sound();
    };
    CHECK(is_sound({1, 8, 1, 0, 0, 0, 0, 5, 5}));
    CHECK_FALSE(is_sound({1, 8, 1, 0, 0, 0, 0, 5}));
    CHECK_FALSE(is_sound({1, 18, 0, 0, 0, 0, 0}));
    CHECK_FALSE(is_sound({1, 3 << 5 | 8, 0, 0, 0, 0, 0}));
    CHECK_FALSE(is_sound({1, 0, 1, 0, 0, 0, 0}));
    CHECK_FALSE(is_sound({1, 8, 1, 0xFF, 0x7F, 0, 0, 1, 0}));
}

}
