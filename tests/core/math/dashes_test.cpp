#include "core/math/dashes.hpp"

#include "tests/core/math/cut_strokes.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::int32_t fine_pixel = 1 << 14; ///< Dashes::of()

std::vector<std::int32_t> fine(const std::vector<double>& pixels)
{
    std::vector<std::int32_t> values;
    values.reserve(pixels.size());
    for (const double length : pixels)
        values.push_back(static_cast<std::int32_t>(std::lround(length * fine_pixel)));
    return values;
}

Trim dashed(const std::vector<double>& lengths, double offset = 0, bool has_dots = false)
{
    Trim trim;
    trim.dashes = Dashes::of(fine(lengths), fine({offset}).front(), has_dots);
    trim.dashes.max = 1024;
    return trim;
}

Trim of_part(Trim dashes, double from, double to, double offset = 0)
{
    const auto share = [](double part) { return static_cast<std::int32_t>(part * Trim::whole); };
    Trim trim = Trim::between(share(from), share(to), share(offset), TrimMode::each);
    trim.dashes = dashes.dashes;
    return trim;
}

/// From a length along the x axis to another.
struct Range {
    double from = 0;
    double to = 0;
};

/// The pieces of a line along the x axis.
std::vector<Range> ranges(const std::vector<Piece>& pieces)
{
    std::vector<Range> result;
    result.reserve(pieces.size());
    for (const Piece& piece : pieces)
        result.push_back({spot(piece.from).x, spot(piece.to()).x});
    return result;
}

void check_ranges(const std::vector<Piece>& pieces, const std::vector<Range>& wanted)
{
    const std::vector<Range> found = ranges(pieces);
    REQUIRE(found.size() == wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(found[i].from - wanted[i].from) < 0.002);
        CHECK(std::abs(found[i].to - wanted[i].to) < 0.002);
    }
}

TestStroke line_of(int length) { return lines({pixels(0, 0), pixels(length, 0)}); }

/// Where the dashes of a stroke should be.
std::vector<Range> exact_dashes(double length, const std::vector<double>& pattern, double offset)
{
    double period = 0;
    for (const double each : pattern)
        period += each;
    std::vector<Range> dashes;
    double at = -std::fmod(offset, period) - (offset < 0 ? period : 0);
    for (std::size_t i = 0; at < length; at += pattern[i++ % pattern.size()]) {
        const Range dash{std::max(at, 0.0), std::min(at + pattern[i % pattern.size()], length)};
        if (i % 2 == 0 && dash.from < dash.to)
            dashes.push_back(dash);
    }
    return dashes;
}

}

TEST_CASE("a line is dashed from its beginning, and from an offset into the pattern")
{
    check_ranges(trimmed({line_of(20)}, dashed({4, 4})), {{0, 4}, {8, 12}, {16, 20}});
    check_ranges(trimmed({line_of(20)}, dashed({4, 4}, 6)), {{2, 6}, {10, 14}, {18, 20}});
    check_ranges(trimmed({line_of(20)}, dashed({4, 4}, -2)), {{2, 6}, {10, 14}, {18, 20}});
    check_ranges(trimmed({line_of(20)}, dashed({4, 4}, 801)), {{0, 3}, {7, 11}, {15, 19}});
    check_ranges(trimmed({line_of(20)}, dashed({6, 1, 2, 1})), {{0, 6}, {7, 9}, {10, 16}, {17, 19}});
}

TEST_CASE("dashes go around corners, and each stroke begins anew")
{
    const TestStroke corner = lines({pixels(0, 0), pixels(10, 0), pixels(10, 10)});
    const auto pieces = trimmed({corner, line_of(5)}, dashed({8, 1}));
    REQUIRE(pieces.size() == 4);
    CHECK(apart(pieces[1].from, {9, 0}) < 0.002);
    CHECK(pieces[1].segments.size() == 2);
    CHECK(apart(pieces[1].to(), {10, 7}) < 0.002);
    CHECK(pieces[3].to() == pixels(5, 0));
}

TEST_CASE("a pattern as long as a line draws it")
{
    CHECK(trimmed({line_of(20)}, dashed({20, 20}, 20)).empty());
    check_ranges(trimmed({line_of(20)}, dashed({20, 20}, 15)), {{0, 5}});
    check_ranges(trimmed({line_of(20)}, dashed({20, 20}, 0)), {{0, 20}});
}

TEST_CASE("dashes meet where a closed stroke begins")
{
    const std::vector square{pixels(0, 0), pixels(10, 0), pixels(10, 10), pixels(0, 10), pixels(0, 0)};
    const auto pieces = trimmed({lines(square, true)}, dashed({10, 10}, 5));
    REQUIRE(pieces.size() == 3);
    CHECK(pieces[0].end == PieceEnd::after_seam);
    CHECK(pieces[0].to() == pixels(5, 0));
    CHECK(pieces[1].end == PieceEnd::open);
    CHECK(pieces[2].end == PieceEnd::at_seam);
    CHECK(pieces[2].to() == pixels(0, 0));
    CHECK(trimmed({lines(square, true)}, dashed({15, 5}))[0].end == PieceEnd::open);
    const auto whole = trimmed({lines(square, true)}, dashed({50, 10}, 10));
    REQUIRE(whole.size() == 1);
    CHECK(whole[0].end == PieceEnd::closed);
}

TEST_CASE("what a trim leaves is dashed from its own beginning, also across the seam")
{
    check_ranges(trimmed({line_of(40)}, of_part(dashed({4, 4}), 0.25, 0.75)), {{10, 14}, {18, 22}, {26, 30}});
    const std::vector square{pixels(0, 0), pixels(10, 0), pixels(10, 10), pixels(0, 10), pixels(0, 0)};
    const auto pieces = trimmed({lines(square, true)}, of_part(dashed({4, 4}), 0, 0.5, 0.775)); // 31 … 51
    REQUIRE(pieces.size() == 4);
    CHECK(pieces[0].end == PieceEnd::after_seam); // of the dash at 39 … 43
    CHECK(apart(pieces[0].to(), {3, 0}) < 0.01);
    CHECK(apart(pieces[1].from, {7, 0}) < 0.01);
    CHECK(apart(pieces[2].from, {0, 9}) < 0.01);
    CHECK(pieces[3].end == PieceEnd::at_seam);
}

TEST_CASE("a dash without length is a dot with a direction, or nothing")
{
    CHECK(trimmed({line_of(20)}, dashed({0, 5})).empty());
    const auto dots = trimmed({line_of(20)}, dashed({0, 5}, 0, true));
    REQUIRE(dots.size() == 4);
    CHECK(std::abs(spot(dots[1].from).x - 5) < 0.002);
    CHECK(spot(dots[1].to()).x - spot(dots[1].from).x > 1 / 128.0);
    CHECK(spot(dots[1].to()).x - spot(dots[1].from).x < 1 / 32.0);
}

TEST_CASE("beyond the most dashes of an object its strokes are whole, and without lengths, too")
{
    Trim trim = dashed({1, 1});
    trim.dashes.max = 3;
    check_ranges(trimmed({line_of(20), line_of(9)}, trim), {{0, 1}, {2, 3}, {4, 5}, {6, 20}, {0, 9}});
    CHECK(dashed({0, 0}).is_whole());
    CHECK(dashed({-3, 0, -1, 0}).is_whole());
    CHECK_FALSE(dashed({1, 0}).is_whole());
    CHECK(trimmed({line_of(2000)}, dashed({0, 0.001})).empty());
}

TEST_CASE("what is not drawn is no dash of an object")
{
    Trim dots = dashed({0, 2});
    dots.dashes.max = 3;
    CHECK(trimmed({line_of(20), line_of(20)}, dots).empty());
    Trim every_other = dashed({0, 2, 1, 2});
    every_other.dashes.max = 3;
    check_ranges(trimmed({line_of(30)}, every_other), {{2, 3}, {7, 8}, {12, 13}, {17, 30}});
}

TEST_CASE("dashes are within 1/16 px of where the length of the curves says")
{
    std::mt19937 random{2};
    double worst = 0;
    for (int i = rounds(300); i > 0; --i) {
        const TestStroke stroke = random_stroke(random);
        const ExactCurve exact{stroke.segments};
        const auto length = [&random] { return 1 + static_cast<double>(random() % 2000) / 64; };
        const std::vector<double> pattern{length(), length(), length(), length()};
        const double offset = 10 * (length() - 16);
        auto pieces = trimmed({stroke}, dashed(pattern, offset));
        std::vector<Range> wanted = exact_dashes(exact.length(), pattern, offset);
        // A trace of a dash at the end may be missing, or be too much.
        if (pieces.size() + 1 == wanted.size() && wanted.back().to - wanted.back().from < 1 / 16.0)
            wanted.pop_back();
        else if (pieces.size() == wanted.size() + 1 &&
                 apart(pieces.back().from, spot(pieces.back().to())) < 1 / 16.0)
            pieces.pop_back();
        REQUIRE(pieces.size() == wanted.size());
        for (std::size_t dash = 0; dash < wanted.size(); ++dash)
            worst = std::max({worst, apart(pieces[dash].from, exact.at_length(wanted[dash].from)),
                              apart(pieces[dash].to(), exact.at_length(wanted[dash].to))});
    }
    CHECK(worst < 1 / 16.0);
}

}
