#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// The findings of a scene of 60 frames whose first line is `nodes`.
std::string errors(const std::string& nodes)
{
    const SceneText text = read("kfast 1; canvas 9 9 frames=60; /*\n*/ " + nodes);
    CHECK(!text.scene);
    return text.findings;
}

}

TEST_CASE("clips are named stretches of the timeline")
{
    const auto [scene, findings] =
        read("kfast 1\ncanvas 9 9 frames=60\nclip blink from=30 to=45\n"
             "clip \"walk on\" loop=repeat to=(s)2 from=0.5\n"
             "clip swing from=0 to=1 loop=ping-pong\nclip hop from=0 to=1 loop=once");
    REQUIRE(scene);
    CHECK(findings == "");
    REQUIRE(scene->clips.size() == 4);
    CHECK(scene->clips[0].name == "blink");
    CHECK(scene->clips[0].begin == Time::frame(30));
    CHECK(scene->clips[0].end == Time::frame(45));
    CHECK(scene->clips[0].loop == Loop::once);
    CHECK(scene->clips[1].name == "walk on");
    CHECK(scene->clips[1].begin == Time{512});
    CHECK(scene->clips[1].end == Time::frame(60));
    CHECK(scene->clips[1].loop == Loop::repeat);
    CHECK(scene->clips[2].loop == Loop::ping_pong);
    CHECK(scene->clips[3].loop == Loop::once);
}

TEST_CASE("a clip lies within the scene and has a length")
{
    CHECK(errors("clip a from=30 to=30") == "2:19 error: this clip ends before anything of it is shown "
                                            "(let to= be later than from=)");
    CHECK(errors("clip a from=30 to=20") == "2:19 error: this clip ends before anything of it is shown "
                                            "(let to= be later than from=)");
    CHECK(errors("clip a from=30 to=60.5") ==
          "2:19 error: this clip ends after the scene, which ends at frame 60 "
          "(choose an earlier time, or make the scene longer with frames=…)");
    CHECK(read("kfast 1\ncanvas 9 9\nobject o fill=red { key 7.5 { empty } }\nclip a from=0 to=8").findings ==
          "4:15 error: this clip ends after the scene, which ends at frame 7.5 "
          "(choose an earlier time, or make the scene longer with frames=…)");
}

TEST_CASE("a clip with mistakes")
{
    CHECK(errors("clip from=0 to=1") ==
          "2:4 error: clip needs more values (write clip NAME from=TIME to=TIME)");
    CHECK(errors("clip a to=1") == "2:4 error: clip needs the property \"from\" (add from=…)");
    CHECK(errors("clip a from=1") == "2:4 error: clip needs the property \"to\" (add to=…)");
    CHECK(errors("clip a from=-1 to=1") == "2:16 error: a time cannot be negative");
    CHECK(errors("clip a from=0 to=1 speed=2") ==
          "2:23 error: clip has no property \"speed\" (allowed: from, to, loop)");
    CHECK(errors("clip a from=0 to=1 loop=twice") ==
          "2:28 error: unknown value \"twice\" (allowed: once, repeat, ping-pong)");
    CHECK(errors("clip \"\" from=0 to=1") == "2:9 error: a name cannot be empty");
    CHECK(errors("clip " + std::string(256, 'a') + " from=0 to=1") ==
          "2:9 error: this name is too long (a name has at most 255 bytes)");
    CHECK(errors("clip a from=0 to=1; clip a from=2 to=3") ==
          "2:24 error: there is a clip \"a\" already, on line 2");
    CHECK(errors("clip a from=0 to=1 { x }") ==
          "2:25 error: clip takes no nodes inside (write clip NAME from=TIME to=TIME)");
}

TEST_CASE("255 clips and no more")
{
    std::string clips;
    for (int i = 0; i < 255; ++i)
        clips += "clip c" + std::to_string(i) + " from=0 to=1\n";
    CHECK(read_on_canvas(clips).scene->clips.size() == 255);
    CHECK(read_on_canvas(clips + "clip more from=0 to=1").findings ==
          "258:1 error: a scene has at most 255 clips");
    CHECK(read_on_canvas("clip " + std::string(255, 'a') + " from=0 to=1").scene);
}

}
