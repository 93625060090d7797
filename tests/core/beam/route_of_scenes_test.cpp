#include "core/beam/beam_route.hpp"
#include "core/beam/nearest_neighbour.hpp"
#include "tests/core/beam/shortest_tour.hpp"
#include "tests/core/beam/traced_scene.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

/// In hundredths of the field's side; together for some pictures of a scene.
struct Travels {
    int pictures = 0;
    double lines = 0;
    double as_drawn = 0;
    double nearest = 0; ///< from each line to the nearest
    double route = 0;
    double shortest = 0; ///< of pictures with few lines

    void add(const BeamLines& drawn)
    {
        constexpr std::size_t few = 8;
        std::vector<BeamLeg> legs(drawn.size());
        for (std::size_t i = 0; i < legs.size(); ++i)
            legs[i].line = static_cast<std::uint16_t>(i);
        ++pictures;
        lines += static_cast<double>(legs.size());
        const auto order = hundredths(drawn, legs);
        as_drawn += order;
        follow_nearest_lines(drawn, {}, legs.size(), legs);
        nearest += hundredths(drawn, legs);
        find_route(drawn, {}, legs);
        const auto found = hundredths(drawn, legs);
        route += found;
        CHECK(found <= order);
        shortest += drawn.size() <= few ? static_cast<double>(ShortestTour{drawn}.travel()) / 655.36 : found;
    }

    static double hundredths(const BeamLines& drawn, const std::vector<BeamLeg>& legs)
    {
        return static_cast<double>(travel_of(drawn, legs)) / 655.36;
    }
};

Travels travels_of(const Bytes& scene)
{
    constexpr int max = rounds(12);
    TracedScene traced{scene};
    Travels travels;
    for (int picture = 0; picture < max; ++picture)
        travels.add(traced.lines({traced.scene().length().ticks / max * picture}));
    return travels;
}

/// With a property of its canvas that has strokes put in order.
std::string with_route(std::string text)
{
    const std::size_t canvas = text.find("\ncanvas ");
    const std::size_t end = text.find('\n', canvas + 1);
    return text.insert(std::min(text.find("//", canvas), end), " route=#true ");
}

std::string text_in(const std::filesystem::path& file)
{
    std::ifstream in{file};
    return {std::istreambuf_iterator<char>{in}, {}};
}

Bytes compiled_file(const std::filesystem::path& file, const std::string& text)
{
    Diagnostics diagnostics;
    const SourceText source{file.string(), text};
    const auto bytes = compile(source, diagnostics);
    REQUIRE(bytes);
    return *bytes;
}

/// Of a scene without and with it.
struct Comparison {
    Travels plain;
    Travels ordered;
};

Comparison compare(const std::filesystem::path& file, const std::string& text)
{
    const Bytes plain = compiled_file(file, text);
    const Bytes ordered = compiled_file(file, with_route(text));
    const Comparison both{travels_of(plain), travels_of(ordered)};
    const auto mean = [](double sum, const Travels& all) {
        return " | " + std::to_string(std::lround(sum / all.pictures));
    };
    MESSAGE(file.stem().string() << mean(both.plain.lines, both.plain)
                                 << mean(both.plain.as_drawn, both.plain)
                                 << mean(both.plain.nearest, both.plain) << mean(both.plain.route, both.plain)
                                 << mean(both.plain.shortest, both.plain)
                                 << mean(both.ordered.as_drawn, both.ordered)
                                 << mean(both.ordered.route, both.ordered) << "; bytes " << plain.size()
                                 << ", " << ordered.size());
    CHECK(both.ordered.as_drawn <= both.plain.as_drawn * 1.001);
    CHECK(both.plain.route <= both.plain.shortest * 1.03);
    return both;
}

std::vector<std::filesystem::path> examples()
{
    std::vector<std::filesystem::path> files;
    for (const char* folder : {"", "reference"})
        for (const auto& entry :
             std::filesystem::directory_iterator{std::filesystem::path{KFAST_EXAMPLES} / folder})
            if (entry.path().extension() == ".kfast")
                files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::string poem(const std::string& font)
{
    return "kfast 1\ncanvas 240 240\nobject poem stroke=white {\n    text \"Two roads diverged\\nin a yellow "
           "wood,\\nAnd sorry I could not\\ntravel both\" at=\"120,60\" size=20 align=center font=" +
           font + "\n}\n";
}

}

TEST_CASE(
    "no example is drawn with more travel than in its own order, and few with more than the shortest tour")
{
    const std::vector<std::filesystem::path> files = examples();
    const int count = rounds(static_cast<int>(files.size()));
    for (const std::filesystem::path& file : std::span{files}.first(static_cast<std::size_t>(count)))
        compare(file, text_in(file));
}

TEST_CASE("text is drawn with less travel if the compiler puts its strokes in order")
{
    for (const std::string font : {"hershey-sans", "hershey-serif"}) {
        const Comparison both = compare(font, poem(font));
        CHECK(both.ordered.route < both.plain.route * 0.9);
    }
}

}
