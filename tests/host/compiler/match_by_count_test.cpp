#include "host/compiler/match/match_by_count.hpp"

#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

/// Lets equalization read what has been joined.
class JoinedReader {
public:
    explicit JoinedReader(const SegmentDrawing& drawing) : drawing_{&drawing} {}

    std::uint32_t strokes() const { return static_cast<std::uint32_t>(drawing_->size()); }
    std::uint32_t next_stroke()
    {
        stroke_ = &(*drawing_)[next_stroke_++];
        next_segment_ = 0;
        return static_cast<std::uint32_t>(stroke_->size());
    }
    Point start() const { return stroke_->front().from; }
    Segment next_segment() { return (*stroke_)[next_segment_++]; }

private:
    const SegmentDrawing* drawing_;
    const std::vector<Segment>* stroke_ = nullptr;
    std::size_t next_stroke_ = 0;
    std::size_t next_segment_ = 0;
};

static_assert(DrawingReader<JoinedReader>);

std::size_t segments_of(const SegmentDrawing& drawing)
{
    std::size_t count = 0;
    for (const auto& stroke : drawing)
        count += stroke.size();
    return count;
}

/// Whether equalization pairs the segments of both as they are, all of one kind.
void check_equal(const Pair<SegmentDrawing>& both)
{
    REQUIRE(segments_of(both.a) == segments_of(both.b));
    std::vector<Segment> a;
    std::vector<Segment> b;
    for (const auto& stroke : both.a)
        a.insert(a.end(), stroke.begin(), stroke.end());
    for (const auto& stroke : both.b)
        b.insert(b.end(), stroke.begin(), stroke.end());
    EqualizedPair pair{JoinedReader{both.a}, JoinedReader{both.b}};
    std::size_t at = 0;
    while (const std::uint32_t segments = pair.next_stroke())
        for (std::uint32_t i = 0; i < segments; ++i, ++at) {
            REQUIRE(at < a.size());
            const Pair<Segment> found = pair.next_segment();
            CHECK(found.a == a[at]);
            CHECK(found.b == b[at]);
            CHECK(found.a.kind == found.b.kind);
        }
    CHECK(at == a.size());
}

class RandomDrawings {
public:
    scene::Drawing drawing()
    {
        scene::Drawing drawing;
        drawing.strokes.resize(random_() % 5);
        for (scene::Stroke& stroke : drawing.strokes) {
            stroke.from = point();
            for (std::size_t left = random_() % 7; left > 0; --left)
                stroke.segments.push_back(random_() % 3 == 0 ? scene::Segment{true, point(), point(), point()}
                                                             : scene::Segment{false, {}, {}, point()});
        }
        return drawing;
    }

private:
    scene::Point point()
    {
        const auto x = static_cast<std::int16_t>(random_() % 3000);
        return {x, static_cast<std::int16_t>(random_() % 3000)};
    }

    std::mt19937 random_{21};
};

}

TEST_CASE("joined drawings are paired without a point being added, whatever they are")
{
    RandomDrawings random;
    for (int round = 0; round < 500; ++round) {
        const scene::Drawing a = random.drawing();
        check_equal(joined(match_by_count(a, random.drawing())));
    }
}

TEST_CASE("whole strokes are paired as equalization pairs them")
{
    const scene::Drawing few = lines({{0, 0}, {160, 0}, {160, 160}});
    const scene::Drawing many = lines({{0, 0}, {80, 0}, {160, 0}, {240, 0}, {320, 0}, {400, 0}});
    const auto [a, b] = joined(match_by_count(few, many));
    REQUIRE(a.size() == 1);
    REQUIRE(a[0].size() == 5);
    EqualizedPair pair{ModelReader{few}, ModelReader{many}};
    REQUIRE(pair.next_stroke() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
        const Pair<Segment> both = pair.next_segment();
        CHECK(a[0][i] == both.a);
        CHECK(b[0][i] == both.b);
    }
}

TEST_CASE("a line that becomes a curve is one")
{
    const auto [a, b] =
        joined(match_by_count(lines({{0, 0}, {480, 0}}), curve({0, 0}, {0, 160}, {160, 160}, {160, 0})));
    CHECK(a[0][0].kind == Segment::Kind::cubic);
    CHECK(a[0][0].c1.x.raw() == doctest::Approx(10 * Fixed::one).epsilon(0.001));
    CHECK(b[0][0].c1.y == Fixed::pixels(10));
}

TEST_CASE("an empty drawing is its partner, drawn together to the centres of its strokes")
{
    const auto [a, b] = joined(match_by_count({}, lines({{0, 0}, {160, 0}, {160, 320}})));
    REQUIRE(a.size() == 1);
    REQUIRE(a[0].size() == 2);
    CHECK(a[0][1] == still_segment({Fixed::pixels(5), Fixed::pixels(10)}));
    CHECK(joined(match_by_count({}, {})).a.empty());
}

TEST_CASE("the parts of a stroke that breaks get as many segments as the largest of them")
{
    const scene::Drawing whole = lines({{0, 0}, {160, 0}, {320, 0}});
    scene::Drawing parts = lines({{0, 0}, {0, 16}, {0, 32}, {0, 48}});
    parts.strokes.push_back(lines({{320, 0}, {320, 16}}).strokes[0]);
    const auto [a, b] = joined(match_by_count(parts, whole));
    CHECK(a.size() == 2);
    CHECK(a[1].size() == 3);
    REQUIRE(b.size() == 1);
    CHECK(b[0].size() == 6);
    CHECK(b[0][2].to == Point{Fixed::pixels(10), {}});
}

}
