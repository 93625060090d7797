#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// What is found in a scene with these inputs, which an object goes by; the inputs are on line 1.
std::string findings(const std::string& inputs, const std::string& inside = "track x input=a { at 0 0 }")
{
    return read_on_canvas(inputs + "\nobject o fill=red {\n" + inside + "\nrect 0 0 2 2 }").findings;
}

scene::Input input(const std::string& text)
{
    const SceneText read =
        read_on_canvas(text + "\nobject o fill=red { track x input=a { at 1 2 }; rect 0 0 2 2 }");
    REQUIRE(read.scene);
    return read.scene->inputs.front();
}

/// "name time:value …" of the first object's track of x.
std::vector<std::int32_t> places_of_x(const std::string& text)
{
    const SceneText read = read_on_canvas(text);
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    std::vector<std::int32_t> places;
    for (const scene::TrackKey& key : read.scene->items.front().tracks.front().keys)
        places.push_back(key.time.ticks);
    return places;
}

}

TEST_CASE("an input has a range and a usual value, in thousandths")
{
    const scene::Input plain = input("input a");
    CHECK(plain.name == "a");
    CHECK(plain.min == 0);
    CHECK(plain.max == 1000);
    CHECK(plain.default_value == 0);
    const scene::Input given = input("input a min=-1.5 max=80000 default=0.0004");
    CHECK(given.min == -1500);
    CHECK(given.max == 80'000'000);
    CHECK(given.default_value == 0);
    CHECK(input("input a min=-9 max=3").default_value == 0);
    CHECK(input("input a min=1 max=3").default_value == 1000);
    CHECK(input("input a min=-3 max=1.0005 default=1").default_value == 1000);
}

TEST_CASE("what is wrong with an input is told once, and it is not missed by what names it")
{
    CHECK(findings("input a max=0") == "3:9 error: the range of this input is empty (let max= be greater "
                                       "than min= (0 and 1 if they are left "
                                       "out))");
    CHECK(findings("input a min=3 max=2").starts_with("3:15 error: the range of this input is empty"));
    CHECK(findings("input a default=2") ==
          "3:9 error: this value is not within min and max (allowed: 0 to 1)");
    CHECK(findings("input a; input a").starts_with("3:10 error: there is an input \"a\" already, on line "));
    CHECK(findings("input a min=-1e7").starts_with("3:13 error: this number is out of range"));
    CHECK(findings("input").starts_with("3:1 error:"));
    CHECK(findings("input a low=1").starts_with("3:9 error: input has no property \"low\""));
    std::string many;
    for (int i = 0; i < 33; ++i)
        many += "input a" + std::to_string(i) + "; ";
    CHECK(findings(many, "rect 1 1 1 1").find("a scene has at most 32 inputs") != std::string::npos);
}

TEST_CASE("an input that is not there, or that nothing goes by, is told")
{
    CHECK(findings("input gaze", "track x input=gase { at 0 0 }; track y input=gaze { at 0 0 }")
              .starts_with("5:15 error: unknown input \"gase\" (did you mean \"gaze\"?)"));
    CHECK(findings("", "track x input=gaze { at 0 0 }") ==
          "5:15 error: unknown input \"gaze\" (add \"input gaze min=0 max=1\" to the scene)");
    CHECK(findings("input a", "rect 3 3 3 3") == "3:1 warning: the input \"a\" moves nothing (add input=a to "
                                                 "a track, an item, a pose or a text, or remove it)");
    CHECK(findings("input a").empty());
}

TEST_CASE("keys by an input stand at values of its range")
{
    constexpr auto begin = "input a min=-1 max=1\nobject o fill=red ";
    CHECK(
        places_of_x(std::string{begin} + "{ track x input=a { at -1 3; at 0.5 4; at 1 5 }; rect 0 0 2 2 }") ==
        std::vector<std::int32_t>{0, 49152, 65536});
    CHECK(places_of_x(std::string{begin} + "input=a { key -1 x=2; key 0 x=3; rect 0 0 2 2 }") ==
          std::vector<std::int32_t>{0, 32768});
    CHECK(findings("input a min=-1 max=1", "track x input=a { at 1.1 0 }") ==
          "5:22 error: this number is out of range (allowed: -1 to 1)");
    CHECK(findings("input a", "track x input=a { at (s)1 0 }").starts_with("5:22 error:"));
    CHECK(findings("input a", "track x input=a { at 0.5 0; at 0.500001 1 }")
              .find("there is a value at this value already, on line ") != std::string::npos);
}

TEST_CASE("keys of an item that has an input go by it, its tracks by what they say")
{
    const SceneText read =
        read_on_canvas("input a\nobject o fill=red input=a {\n"
                       "key 0 y=1 { rect 0 0 2 2 }; key 1 y=2 { circle 5 5 r=2 }\n"
                       "track x { at 0 0; at 9 9 } }\n"
                       "group input=a { key 0 x=1; key 1 x=2; object p fill=red { rect 0 0 1 1 } }\n"
                       "symbol s { object q fill=red { rect 0 0 1 1 } }\n"
                       "use s input=a { key 0 z=1; key 1 z=2 }");
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    const auto& items = read.scene->items;
    CHECK(std::get<scene::Object>(items[0].content).driver == Driver{1});
    CHECK(items[0].tracks[0].driver.is_time());
    CHECK(items[0].tracks[1].driver == Driver{1});
    CHECK(items[1].tracks[0].driver == Driver{1});
    CHECK(items[2].tracks[0].driver == Driver{1});
    CHECK(read.scene->length == Time::frame(9));
}

TEST_CASE("keys by an input come in the order of its values, and are seen beyond the end of the scene")
{
    CHECK(findings("input a max=9", "track y input=a { at 0 0; at 9 1 }").empty());
    const std::string text =
        read_on_canvas("input a max=9\nobject o fill=red input=a { key 3 x=1; key 2 x=2\n"
                       "rect 0 0 2 2 }")
            .findings;
    CHECK(text.find("this key is lower than the one before it, on line ") != std::string::npos);
    CHECK(text.find("(put the keys in the order of their values)") != std::string::npos);
}

TEST_CASE("poses go by the time or by an input, all of one bone by the same")
{
    const std::string begin = "input a min=-1 max=1\nbones s {\nbone b 0 0 9 0 { bone c 9 0 19 0 }\n";
    const std::string end = "\n}\nobject o fill=red skin=s { rect 0 0 19 2 }";
    const SceneText good = read_on_canvas(begin +
                                          "pose 0 { b turn=1 }; pose -1 input=a { c turn=-9 }\n"
                                          "pose 9 { b turn=3 }; pose 1 input=a { c turn=9 }" +
                                          end);
    CAPTURE(good.findings);
    REQUIRE(good.scene);
    const auto& bones = good.scene->bones.front().bones;
    CHECK(bones[0].driver.is_time());
    CHECK(bones[1].driver == Driver{1});
    CHECK(bones[1].keys[0].back().time == Time{65536});
    CHECK(read_on_canvas(begin + "pose 0 rest; pose 0 input=a { c turn=9 }" + end)
              .findings.find("the bone \"c\" goes by something else on line ") != std::string::npos);
    CHECK(read_on_canvas(begin + "pose 1 input=a { c turn=9 }; pose 0 input=a { c turn=3 }" + end)
              .findings.find("this pose is lower than the one before it") != std::string::npos);
    CHECK(read_on_canvas(begin +
                         "pose -1 input=a { b turn=9 }; pose 1 input=a { b turn=3 }\n"
                         "reach c bend=left { at 0 10 10 }" +
                         end)
              .findings.find("this reach goes by the time, but an input moves \"b\"") != std::string::npos);
}

TEST_CASE("keys by an input are told apart in 1/65536 of its range, however fine its values are")
{
    CHECK(places_of_x(
              "input a max=0.01\nobject o fill=red { track x input=a { at 0 0; at 0.00001 1; at 0.01 2 }\n"
              "rect 0 0 2 2 }") == std::vector<std::int32_t>{0, 66, 65536});
    CHECK(findings("input a", "track x input=a { at 0 0; at 0.0004 1 }").empty());
}

TEST_CASE("an input that moves none of the keys of its item is warned of")
{
    CHECK(read_on_canvas("input a\nobject o fill=red input=a { rect 0 0 2 2; track x input=a { at 0 1 } }")
              .findings ==
          "4:19 warning: this input moves nothing: there are no keys (add keys, or remove input=…)");
    CHECK(read_on_canvas("input a\ngroup input=a { object o fill=red { rect 0 0 2 2 } }")
              .findings.starts_with("4:7 warning: this input moves nothing"));
}

TEST_CASE("skeletons go by the input of their object, also where its drawing stands outside of keys")
{
    const SceneText read = read_on_canvas("input a\nobject o fill=red input=a { line 0 5 20 5\n"
                                          "key 0 { skeleton { backbone 0 5 20 5; width 4 } }\n"
                                          "key 1 { skeleton { backbone 0 5 20 9; width 4 } } }");
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    CHECK(object_at(*read.scene).driver == Driver{1});
    CHECK(read_on_canvas("input a\nsymbol s { key 0 { rect 0 0 1 1 }; key 9 { rect 1 1 1 1 } }\n"
                         "object o fill=red input=a { use s; key 0 x=1; key 1 x=2 }")
              .findings.find("this object goes by an input, but the drawings of its symbol by the time") !=
          std::string::npos);
}

}
