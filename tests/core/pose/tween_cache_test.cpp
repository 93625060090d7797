#include "core/pose/tween_cache.hpp"

#include "core/pose/posed_bones.hpp"
#include "tests/core/raw_drawing.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

/// A stroke between two drawings, as it is told.
struct InputStroke {
    std::vector<Point> points;
    std::vector<bool> cubics;
    Point hub;
    bool is_whole = false;
    bool is_closed = false;

    friend bool operator==(const InputStroke&, const InputStroke&) = default;
};

Point between(const Pair<Point>& both, ProgressXY progress)
{
    return lerp(both.a, both.b, progress.x, progress.y);
}

std::vector<InputStroke> streamed(EqualizedPair<DeformedDrawing> pair, ProgressXY progress)
{
    std::vector<InputStroke> strokes;
    while (const std::uint32_t segments = pair.next_stroke()) {
        InputStroke& stroke = strokes.emplace_back();
        Pair<Point> first;
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Pair<Segment>& both = pair.next_segment();
            REQUIRE(both.a.kind == both.b.kind);
            if (i == 0) {
                first = {both.a.from, both.b.from};
                stroke.points.push_back(between(first, progress));
            }
            stroke.cubics.push_back(both.a.kind == Segment::Kind::cubic);
            if (stroke.cubics.back()) {
                stroke.points.push_back(between({both.a.c1, both.b.c1}, progress));
                stroke.points.push_back(between({both.a.c2, both.b.c2}, progress));
            }
            stroke.points.push_back(between({both.a.to, both.b.to}, progress));
            stroke.is_closed = pair.is_whole() && first.a == both.a.to && first.b == both.b.to;
        }
        stroke.is_whole = pair.is_whole();
        stroke.hub = stroke.is_whole ? stroke.points.front() : between(pair.hub(), progress);
    }
    return strokes;
}

/// By one of the two ways to read points.
std::vector<InputStroke> kept(TweenReader tween, ProgressXY progress, bool by_twos)
{
    const auto next = [&] {
        return by_twos ? between(tween.next_points(), progress) : tween.next_point(progress);
    };
    std::vector<InputStroke> strokes;
    for (std::uint32_t i = 0; i < tween.strokes(); ++i) {
        InputStroke& stroke = strokes.emplace_back();
        const std::uint32_t segments = tween.next_stroke();
        stroke.points.push_back(next());
        for (std::uint32_t segment = 0; segment < segments; ++segment) {
            stroke.cubics.push_back(tween.is_next_cubic());
            for (int points = stroke.cubics.back() ? 3 : 1; points > 0; --points)
                stroke.points.push_back(next());
        }
        stroke.is_whole = tween.is_whole();
        stroke.is_closed = tween.is_closed();
        stroke.hub = stroke.is_whole ? stroke.points.front() : between(tween.hub(), progress);
    }
    return strokes;
}

/// Two drawings in one section.
struct Drawings {
    Drawings(const scene::Drawing& a, const scene::Drawing& b) : from{raw.add(a)}, to{raw.add(b)} {}

    EqualizedPair<DeformedDrawing> pair() const
    {
        return {DeformedDrawing{drawing_at(raw.bytes(), from)}, DeformedDrawing{drawing_at(raw.bytes(), to)}};
    }

    RawDrawings raw;
    std::uint32_t from;
    std::uint32_t to;
};

struct Memory {
    explicit Memory(std::size_t count) : words(count), cache{std::as_writable_bytes(std::span{words})} {}

    std::vector<std::uint32_t> words;
    PictureCache cache;
};

ProgressXY random_progress(std::mt19937& random)
{
    const auto progress = [&random] {
        return Progress{std::uniform_int_distribution<std::int32_t>{-98304, 163840}(random)};
    };
    const Progress x = progress();
    return {x, progress()};
}

/// At the ends of what coordinates can be, or near each other.
scene::Drawing spread(scene::Drawing drawing, int factor)
{
    const auto move = [factor](scene::Point& point) {
        point.x = static_cast<std::int16_t>((point.x - 4096) * factor / 4);
        point.y = static_cast<std::int16_t>((point.y - 4096) * factor / 4);
    };
    for (scene::Stroke& stroke : drawing.strokes) {
        move(stroke.from);
        for (scene::Segment& segment : stroke.segments) {
            move(segment.c1);
            move(segment.c2);
            move(segment.to);
        }
    }
    return drawing;
}

}

TEST_CASE("drawings that are kept come to the same strokes as those that are made equal anew")
{
    std::mt19937 random{30};
    int parts = 0;
    int closed = 0;
    for (int round = 0; round < rounds(3'000); ++round) {
        const int factor = 1 << random() % 5;
        scene::Drawing a = spread(random_drawing(random), factor);
        scene::Drawing b = spread(round % 3 == 0 ? random_drawing_like(a, random) : random_drawing(random),
                                  round % 3 == 0 ? 4 : factor);
        if (round % 50 == 0)
            a.strokes.clear();
        for (scene::Drawing* drawing : {&a, &b})
            for (scene::Stroke& stroke : drawing->strokes)
                if (random() % 2 == 0 && !stroke.segments.empty())
                    stroke.segments.back().to = stroke.from;
        const Drawings drawings{a, b};
        Memory memory{2'000};
        const ProgressXY progress = random_progress(random);
        const std::vector<InputStroke> strokes = streamed(drawings.pair(), progress);
        for (const bool by_twos : {false, true}) {
            const auto tween = kept_tween(memory.cache, drawings.raw.bytes(), drawings.from, drawings.to);
            REQUIRE(tween);
            REQUIRE(kept(*tween, progress, by_twos) == strokes);
        }
        for (const InputStroke& stroke : strokes) {
            parts += stroke.is_whole ? 0 : 1;
            closed += stroke.is_closed ? 1 : 0;
        }
    }
    CHECK(parts > rounds(300));
    CHECK(closed > rounds(300));
}

TEST_CASE("a drawing beside itself takes half the room, and so do short distances")
{
    const auto bytes_of = [](const scene::Drawing& a, const scene::Drawing& b, bool is_one) {
        const Drawings drawings{a, b};
        Memory memory{500};
        const std::uint32_t to = is_one ? drawings.from : drawings.to;
        REQUIRE(kept_tween(memory.cache, drawings.raw.bytes(), drawings.from, to));
        return memory.cache.bytes_in_use();
    };
    constexpr std::size_t head = 16 + 4 + 4 + 4; // name, form, segments, kinds
    const scene::Drawing line{{polyline_of({{0, 0}, {160, 16}, {320, 480}})}};
    const scene::Drawing far{{polyline_of({{0, 0}, {8192, 16}, {320, 480}})}};
    CHECK(bytes_of(line, line, true) == head + 3 * 4);
    CHECK(bytes_of(line, line, false) == head + 3 * 8);
    CHECK(bytes_of(far, far, true) == head + 3 * 8);
    CHECK(bytes_of(line, far, false) == head + 3 * 16);
}

TEST_CASE("drawings of the same make are plain: on the first key lies the first one itself")
{
    const auto is_plain = [](const scene::Drawing& a, const scene::Drawing& b) {
        const Drawings drawings{a, b};
        Memory memory{500};
        return kept_tween(memory.cache, drawings.raw.bytes(), drawings.from, drawings.to)->is_plain();
    };
    const scene::Drawing open{{polyline_of({{0, 0}, {160, 16}, {320, 480}})}};
    const scene::Drawing other{{polyline_of({{5, 0}, {160, 19}, {7, 480}})}};
    const scene::Drawing closed{{polyline_of({{0, 0}, {160, 16}, {0, 0}})}};
    const scene::Drawing longer{{polyline_of({{0, 0}, {160, 16}, {0, 30}, {40, 40}})}};
    const scene::Drawing two{{open.strokes[0], other.strokes[0]}};
    scene::Drawing curve = open;
    curve.strokes[0].segments[0].cubic = true;
    CHECK(is_plain(open, other));
    CHECK(is_plain(closed, closed));
    CHECK(is_plain(open, closed));
    CHECK_FALSE(is_plain(closed, open)); // it would be closed on the key, and is not between them
    CHECK_FALSE(is_plain(open, longer));
    CHECK_FALSE(is_plain(longer, open));
    CHECK_FALSE(is_plain(open, two));
    CHECK_FALSE(is_plain(curve, open));
    CHECK_FALSE(is_plain(open, {}));
    CHECK(is_plain({}, {}));
}

TEST_CASE("what finds no room is not kept, and nothing else is touched")
{
    std::mt19937 random{31};
    for (int round = 0; round < 300; ++round) {
        const Drawings drawings{random_drawing(random), random_drawing(random)};
        Memory enough{2'000};
        REQUIRE(kept_tween(enough.cache, drawings.raw.bytes(), drawings.from, drawings.to));
        const std::size_t words = enough.cache.bytes_in_use() / 4;
        Memory exact{words};
        CHECK(kept_tween(exact.cache, drawings.raw.bytes(), drawings.from, drawings.to));
        const std::size_t too_few = random() % words;
        std::vector<std::uint32_t> guarded(words + 8, 0x5A5A'5A5A);
        PictureCache less{std::as_writable_bytes(std::span{guarded}.first(too_few))};
        CHECK_FALSE(kept_tween(less, drawings.raw.bytes(), drawings.from, drawings.to));
        for (std::size_t behind = too_few; behind != guarded.size(); ++behind)
            REQUIRE(guarded[behind] == 0x5A5A'5A5A);
    }
}

}
