#include "core/scene/packed_drawing.hpp"

#include "host/compiler/match/match_by_count.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/compiler/pack/pack_drawing.hpp"
#include "tests/bytes.hpp"
#include "tests/core/random_strokes.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

using Bytes = std::vector<std::byte>;

void check_same(PackedDrawing packed, const scene::Drawing& drawing)
{
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
    CHECK(packed.is_valid());
}

std::size_t form_size(const scene::Stroke& stroke) { return packed_form(steps_of(stroke)).size(); }

scene::Segment line_to(std::int16_t x, std::int16_t y) { return {false, {}, {}, {x, y}}; }

scene::Segment curve_to(scene::Point c1, scene::Point c2, scene::Point to) { return {true, c1, c2, to}; }

bool has_16_bits(Point point)
{
    const auto fits = [](Fixed value) { return std::abs(value.raw()) <= 32768 * (Fixed::one / 16); };
    return fits(point.x) && fits(point.y);
}

/// As far as coordinates have 16 bits.
bool is_valid(const Bytes& bytes)
{
    PackedDrawing drawing = drawing_at(bytes, 0);
    for (std::uint32_t stroke = 0; stroke < drawing.strokes() && drawing.is_valid(); ++stroke) {
        std::uint32_t segments = drawing.next_stroke();
        if (!has_16_bits(drawing.start()))
            return false;
        for (; segments > 0 && drawing.is_valid(); --segments) {
            const Segment segment = drawing.next_segment();
            if (!has_16_bits(segment.c1) || !has_16_bits(segment.c2) || !has_16_bits(segment.to))
                return false;
        }
    }
    return drawing.is_valid();
}

}

TEST_CASE("what is packed is read back, bit for bit")
{
    RandomStrokes random{51};
    for (int round = 0; round < 5000; ++round) {
        const scene::Drawing drawing = random.drawing();
        ByteWriter bytes;
        pack_drawing(drawing, bytes);
        check_same(drawing_at(bytes.bytes(), 0), drawing);
    }
}

TEST_CASE("coordinates may be as far apart as 16 bits allow")
{
    scene::Stroke stroke{{-32768, 32767}, {}};
    stroke.segments = {line_to(32767, -32768), line_to(-32768, 32767), line_to(-32768, -32768),
                       curve_to({32767, 32767}, {-32768, 32767}, {32767, -32768}),
                       curve_to({32767, -32768}, {32767, 32767}, {-32768, -32768})};
    const scene::Drawing drawing{{stroke, {{32767, -32768}, {}}, stroke}};
    DrawingPool pool;
    const std::int32_t offset = pool.offset_of(drawing);
    check_same(drawing_at(pool.bytes(), static_cast<std::uint32_t>(offset)), drawing);
}

TEST_CASE("drawings that share strokes are read back wherever they lie in a pool")
{
    RandomStrokes random{52};
    for (int round = 0; round < 100; ++round) {
        DrawingPool pool;
        std::vector<scene::Drawing> drawings;
        std::vector<std::int32_t> offsets;
        for (int count = 0; count < 30; ++count) {
            drawings.push_back(random.drawing());
            offsets.push_back(pool.offset_of(drawings.back()));
        }
        for (std::size_t i = 0; i < drawings.size(); ++i) {
            CHECK(pool.offset_of(drawings[i]) == offsets[i]);
            check_same(drawing_at(pool.bytes(), static_cast<std::uint32_t>(offsets[i])), drawings[i]);
        }
    }
}

TEST_CASE("simple strokes take few bytes")
{
    // A form has three bytes before its bits.
    const scene::Stroke open{{0, 0}, {line_to(300, 10), line_to(270, 440), line_to(-100, 200)}};
    CHECK(form_size(open) == 3 + 8); // 6 numbers of 10 bits
    scene::Stroke closed = open;
    closed.segments.push_back(line_to(0, 0));
    CHECK(form_size(closed) == 3 + 8); // the last end is known
    const scene::Stroke square{{160, 160},
                               {line_to(480, 160), line_to(480, 480), line_to(160, 480), line_to(160, 160)}};
    CHECK(form_size(square) == 3 + 3); // of half of it, a coordinate of 10 bits and two more each
    const scene::Stroke circle{
        {0, -100},
        {curve_to({55, -100}, {100, -55}, {100, 0}), curve_to({100, 55}, {55, 100}, {0, 100}),
         curve_to({-55, 100}, {-100, 55}, {-100, 0}), curve_to({-100, -55}, {-55, -100}, {0, -100})}};
    CHECK(form_size(circle) == 3 + 8); // 2 ends of 16 bits, 3 control points of 10, 2 bits which are smooth
    CHECK(form_size({{7, 7}, {}}) == 3);
}

TEST_CASE("curves that hardly differ from parabolas take a byte for each")
{
    scene::Stroke wave{{0, 0}, {}};
    for (int i = 0; i < 20; ++i) {
        const auto at = [i](int x, int y) {
            return scene::Point{static_cast<std::int16_t>(100 * i + x),
                                static_cast<std::int16_t>(i % 2 == 0 ? y : -y)};
        };
        wave.segments.push_back(curve_to(at(33, 400), at(67, 400), at(100, 0)));
    }
    CHECK(form_size(wave) <= 4 + 20 * 3);
}

TEST_CASE("a predicted end is the same, mirrored, for mirrored control points")
{
    for (int out = -50; out <= 50; ++out)
        for (int in = -50; in <= 50; ++in) {
            CHECK(predicted_end(out, in) == -predicted_end(-out, -in));
            CHECK(std::abs(2 * predicted_end(out, in) - 3 * (out + in)) <= 1);
        }
    CHECK(predicted_end(10, 10) == 30); // a line
}

TEST_CASE("a stroke is stored once, wherever it begins, also mirrored")
{
    const scene::Stroke hook{{100, 100},
                             {line_to(300, 110), line_to(270, 440), curve_to({9, 9}, {90, 30}, {50, 60})}};
    const scene::Stroke other{
        {10, 400}, {line_to(-190, 410), line_to(-160, 740), curve_to({101, 309}, {20, 330}, {60, 360})}};
    DrawingPool pool;
    pool.offset_of(scene::Drawing{{hook}});
    const std::size_t once = pool.bytes().size();
    pool.offset_of(scene::Drawing{{other}});
    CHECK(pool.bytes().size() == once + 1 + 1 + 2 + 2); // strokes, start, the repeat
}

TEST_CASE("a drawing that is cut or has bits without a meaning is not sound")
{
    const auto sound = [](std::initializer_list<int> values) { return is_valid(bytes(values)); };
    CHECK(sound({1, 0, 0, 0, 8, 2, 5, 5}));
    CHECK_FALSE(sound({1, 0, 0, 0, 8, 2, 5}));
    CHECK_FALSE(sound({1, 0, 0, 0, 8, 2}));
    CHECK_FALSE(sound({1, 0, 0, 0, 8}));
    CHECK_FALSE(sound({1, 0, 0}));
    CHECK_FALSE(sound({1}));
    CHECK(sound({1, 0, 0, 0, 17, 0}));
    CHECK_FALSE(sound({1, 0, 0, 0, 18, 0}));   // too wide
    CHECK_FALSE(sound({1, 0, 0, 0, 0, 0}));    // no width
    CHECK_FALSE(sound({1, 0, 0, 0x0C, 8, 0})); // a fourth kind of end
    for (const int bit : {0x20, 0x40, 0x80})
        CHECK_FALSE(sound({1, 0, 0, bit, 8, 0})); // lines have no control points
    CHECK_FALSE(sound({1, 0, 0, 0, 0x28, 0}));
    CHECK(sound({1, 0, 0, 1, 0xE8, 0}));
    CHECK_FALSE(sound({1, 0, 0, 1, 0xE7, 0})); // control points without a width
    CHECK(sound({1, 0, 0, 8, 8, 4, 5, 5}));
    CHECK_FALSE(sound({1, 0, 0, 8, 8, 6, 5, 5})); // no half of three
    CHECK(sound({1, 0, 0, 1, 8, 1, 17}));
    CHECK_FALSE(sound({1, 0, 0, 1, 8, 1}));
    CHECK_FALSE(sound({1, 0, 0, 1, 8, 1, 18})); // too wide
    CHECK_FALSE(sound({1, 0, 0, 1, 8, 1, 0}));  // no width
    CHECK_FALSE(sound({1, 0, 0, 0, 8, 1, 17})); // nothing to foretell
}

TEST_CASE("a form elsewhere is there, and not elsewhere again")
{
    const auto sound = [](int head, int offset) {
        return is_valid(bytes({2, 0, 0, 0, 8, 2, 5, 5, 0, 0, head, offset, 0, 0}));
    };
    CHECK(sound(3, 3));
    CHECK(sound(0x0F, 3));
    for (const int bit : {0x10, 0x20, 0x40, 0x80})
        CHECK_FALSE(sound(3 | bit, 3));
    CHECK_FALSE(sound(3, 10)); // itself
    CHECK_FALSE(sound(3, 13)); // cut
    CHECK_FALSE(sound(3, 14));
    CHECK_FALSE(is_valid(bytes({1, 0, 0, 3, 0xFF, 0xFF, 0xFF, 0xFF, 0x0F})));
}

TEST_CASE("whatever the bytes are, they can be read as far as they are sound")
{
    std::mt19937 random{53};
    int sound = 0;
    for (int round = 0; round < 50'000; ++round) {
        Bytes bytes(1 + random() % 60); // their ends are watched by the address sanitizer
        for (std::byte& byte : bytes)
            byte = static_cast<std::byte>(random());
        bytes[0] = static_cast<std::byte>(random() % 3);
        sound += is_valid(bytes) ? 1 : 0;
    }
    CHECK(sound > 1000);
}

}
