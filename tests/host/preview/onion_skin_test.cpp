#include "host/preview/overlay/onion_skin.hpp"

#include "host/picture/player_source.hpp"
#include "tests/host/preview/named_scene.hpp"

#include <doctest/doctest.h>

#include <array>

namespace kfast::test {
namespace {

Picture pixels(std::vector<Colour> colours)
{
    const int width = static_cast<int>(colours.size());
    return {{width, 1}, std::move(colours)};
}

constexpr Colour black{0, 0, 0};
constexpr Colour white{255, 255, 255};

/// Notes which moments were asked for.
class NotingSource final : public FrameSource {
public:
    explicit NotingSource(const SceneView& scene, PixelFormat format)
        : source_{scene, scene.canvas(), Fit::contain, format}
    {
    }

    const Frame& show(Time moment) override
    {
        shown.push_back(moment.ticks / Time::ticks_per_frame);
        return source_.show(moment);
    }
    bool set(std::uint32_t, const InputContent&) override { return true; }

    std::vector<int> shown;

private:
    PlayerSource source_;
};

constexpr const char* leaping = R"(kfast 1
canvas 40 20 frames=30 background="#204080"
object still fill=white { rect 0 0 6 6 }
object box fill=red { key 0 x=0 law=hold; key 10 x=10 law=hold; key 20 x=20; rect 0 10 8 8 }
)";
constexpr std::array keys{Time::frame(0), Time::frame(10), Time::frame(20)};

}

TEST_CASE("a neighbour counts where it differs from the picture and from the ground")
{
    Picture picture = pixels({black, white, {0, 200, 0}, black, {10, 10, 10}});
    const Picture neighbour = pixels({white, black, {0, 200, 0}, black, {20, 10, 10}});
    const Picture ground = pixels({black, black, black, black, black});
    lay_skin(picture, neighbour, ground, {255, 128, 48});
    CHECK(picture.pixels[0] == Colour{128, 64, 24}); // 255 128/255, 128 128/255 = 64.25, 48 128/255 = 24.09
    CHECK(picture.pixels[1] == white);
    CHECK(picture.pixels[2] == Colour{0, 200, 0});
    CHECK(picture.pixels[3] == black);
    // w = 3 x 10: 10 + 245 30 128 / 255^2 = 24.47, 10 + 118 ... = 16.97, 10 + 38 ... = 12.24
    CHECK(picture.pixels[4] == Colour{24, 17, 12});
}

TEST_CASE("shades are rounded away from the picture on either side")
{
    // 255 x 128 / 255 = 128; towards 0: 255 - 128
    Picture picture = pixels({white});
    lay_skin(picture, pixels({black}), pixels({{0, 255, 0}}), {0, 255, 0});
    CHECK(picture.pixels[0] == Colour{127, 255, 127});
}

TEST_CASE("the key frames before and after are seen, all else is exactly the picture")
{
    const NamedScene scene{leaping};
    for (const PixelFormat format : {PixelFormat::rgb565, PixelFormat::grey4, PixelFormat::mono1_dithered}) {
        CAPTURE(static_cast<int>(format));
        NotingSource source{scene.view(), format};
        OnionSkin skin{scene.view().colour(0)};
        const Picture seen = skin.show(source, Time::frame(10), keys);
        const Picture plain = widen(source.show(Time::frame(10)));
        int before = 0;
        int after = 0;
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 40; ++x) {
                const bool differs = !(seen.at(x, y) == plain.at(x, y));
                const bool is_in_box = y >= 10 && y < 18;
                before += is_in_box && x < 8 && differs ? 1 : 0;
                after += is_in_box && x >= 20 && x < 28 && differs ? 1 : 0;
                if (!is_in_box || x >= 28 || (x >= 8 && x < 20))
                    CHECK_FALSE(differs);
            }
        CHECK(before == after);
        CHECK(before > 0);
        if (format == PixelFormat::rgb565)
            CHECK(before == 64);
    }
}

TEST_CASE("key frames are drawn once, and the picture last")
{
    const NamedScene scene{leaping};
    NotingSource source{scene.view(), PixelFormat::rgb565};
    OnionSkin skin{scene.view().colour(0)};
    for (const int frame : {3, 4, 10, 12, 25})
        skin.show(source, Time::frame(frame), keys);
    CHECK(source.shown == std::vector<int>{0, 10, 3, 4, 0 + 20, 10, 10, 12, 20, 25});
    skin.forget();
    skin.show(source, Time::frame(25), keys);
    CHECK(source.shown.back() == 25);
}

}
