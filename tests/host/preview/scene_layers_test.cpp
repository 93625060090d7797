#include "host/preview/viewer/opened_scene.hpp"

#include "tests/host/preview/opened_scenes.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <fstream>

namespace kfast::test {
namespace {

/// Objects that leap at their keys, one of them in a group, and a clip between some of them.
constexpr const char* leaping = R"(kfast 1
canvas 60 30 fps=10 frames=60
clip turn from=10 to=40
object a fill=red { key 0 x=0 law=hold; key 20 x=10 law=hold; key 60 x=20; rect 0 0 8 8 }
group pair {
    object b fill=lime { key 0 x=0 law=hold; key 30 x=10 law=hold; key 40 x=20 law=hold; key 50 x=30; rect 0 10 8 8 }
}
)";

struct Layers {
    /// What is shown at frame 25 of the clip with this object selected.
    Picture shown(std::optional<std::string> name)
    {
        const TimeRow* const row = name ? layers.table().row_named(*name) : nullptr;
        return layers.onion_skin(playback, row == nullptr ? std::nullopt : std::optional{row->item});
    }
    Picture expected(std::vector<Time> keys)
    {
        return OnionSkin{scene->scene.view.colour(0)}.show(*scene->source, Time::frame(25), keys);
    }

    TemporaryFolder folder;
    bool is_written = (std::ofstream{folder / "leaping.kfast"} << leaping, true);
    std::unique_ptr<OpenedScene> scene = open_scene(folder / "leaping.kfast");
    SceneLayers layers{*scene};
    PreviewPlayback playback{scene->playback_setup, Pace::smooth, PreviewPlayback::Seconds{0}};
};

}

TEST_CASE("the onion skin is of the keys of what is selected, and of the clip that plays")
{
    Layers all;
    all.playback.scrub(Time::frame(25));
    CHECK(all.shown({}).pixels == all.expected({Time::frame(20), Time::frame(30)}).pixels);
    CHECK(all.shown("a").pixels == all.expected({Time::frame(20), Time::frame(60)}).pixels);
    for (const char* const name : {"b", "pair"})
        CHECK(all.shown(name).pixels == all.expected({Time::frame(0), Time::frame(30)}).pixels);
    CHECK(all.shown("a").pixels != all.shown("b").pixels);

    all.playback.press(PreviewKey::next_clip, PreviewPlayback::Seconds{0});
    all.playback.scrub(Time::frame(25));
    CHECK(all.playback.part().name == "turn");
    CHECK(all.shown({}).pixels == all.expected({Time::frame(20), Time::frame(30)}).pixels);
    CHECK(all.shown("a").pixels == all.expected({Time::frame(20)}).pixels);
    CHECK(all.shown("b").pixels == all.expected({Time::frame(30)}).pixels);
}

}
