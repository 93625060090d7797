#include "host/picture/player_source.hpp"
#include "tests/compiled.hpp"
#include "tests/host/scene_text/random_scene.hpp"
#include "tests/host/scene_text/reference_picture.hpp"
#include "tests/host/scene_text/written.hpp"
#include "tests/rounds.hpp"

#include <cmath>

namespace kfast::test {
namespace {

/// How far two pictures are from each other, channels being 0 to 1.
struct Difference {
    double mean = 0;
    double largest = 0;
};

Difference difference(const Frame& frame, const Picture& picture)
{
    Difference difference;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double shown = std::to_integer<int>(frame.pixels[3 * i + channel]) / 252.0;
            const double error = std::abs(shown - picture.pixels[i][channel]);
            difference.mean += error / static_cast<double>(3 * picture.pixels.size());
            difference.largest = std::max(difference.largest, error);
        }
    return difference;
}

/// Compares pictures, and counts those that rounding has moved far: in groups that grow within groups, or in
/// what is baked there.
class Comparison {
public:
    void compare(const art::Document& document, const std::string& text, std::span<const double> times)
    {
        const auto bytes = compiled(text);
        constexpr int size = static_cast<int>(RandomScene::size);
        PlayerSource source{*SceneView::parse(bytes), {size, size}, Fit::contain, PixelFormat::rgb666};
        for (const double time : times) {
            INFO("time ", time);
            const Time moment{static_cast<std::int32_t>(time * Time::ticks_per_frame)};
            const double shown = static_cast<double>(moment.ticks) / Time::ticks_per_frame;
            const auto [mean, largest] = difference(source.show(moment), reference_picture(document, shown));
            CHECK(mean < 0.01);
            CHECK(largest < 0.75);
            ++pictures_;
            if (mean > 0.005 || largest > 0.4)
                ++far_;
        }
    }

    double share_of_far() const { return static_cast<double>(far_) / pictures_; }

private:
    int pictures_ = 0;
    int far_ = 0;
};

}

TEST_CASE("documents of any kind look as they are written")
{
    Comparison comparison;
    constexpr std::array times{0.03, 7.3, 13.7, 21.1, 33.9};
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(150)); ++seed) {
        INFO("seed ", seed);
        const art::Document document = RandomScene{seed}.document(static_cast<int>(seed % 5));
        art::Losses losses;
        const std::string text = written(document, losses);
        INFO(text);
        comparison.compare(document, text, times);
    }
    CHECK(comparison.share_of_far() < 0.02);
}

TEST_CASE("groups that lie too deep in each other look as they are written")
{
    Comparison comparison;
    constexpr std::array times{0.03, 13.7, 33.9};
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(12)); ++seed) {
        INFO("seed ", seed);
        art::Document document = RandomScene{seed}.document(3);
        for (unsigned level = 0; level < 9; ++level) {
            art::Node outer;
            outer.name = "level";
            outer.content = art::Group{std::move(document.nodes)};
            outer.transform.anchor_x = outer.transform.anchor_y = outer.transform.x =
                outer.transform.y = {32};
            outer.transform.rotate = art::Channel{{{0, 0, {}}, {40, 7.0 + level, {}}}};
            document.nodes =
                std::vector{std::move(outer), RandomScene{seed + level}.document(0).nodes.front()};
        }
        art::Losses losses;
        const std::string text = written(document, losses);
        INFO(text);
        comparison.compare(document, text, times);
    }
    CHECK(comparison.share_of_far() < 0.02);
}

}
