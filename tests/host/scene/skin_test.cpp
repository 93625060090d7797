#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("points follow the bones in whose regions they lie, the nearer the more")
{
    CHECK(skin_read("object o fill=red skin=s { path \"M 20 70 L 15 60 24 46 20 40 30 40 50 45\" }") ==
          "a a a|b:94 a|b:128 b b");
    CHECK(skin_read("object o fill=red skin=s { path \"M 20 70 L 24 46\"; weights auto }") == "a a|b:94");
    CHECK(skin_read("object o fill=red skin=s { path \"M 20 70 L 24 46\"; weights mean }") == "a a|b:128");
}

TEST_CASE("points in no region follow the nearest bone, with one warning")
{
    CHECK(skin_read("object o fill=red skin=s { path \"M 20 70 L 40 70 80 40.5 25 50\" }") ==
          "a a b a\n"
          "1:1 warning: 2 points of this object lie in no region of a bone, the first at 40, 70; the nearest "
          "bone takes them (let a bone have a larger region=…, or give weights)");
    CHECK(skin_read("object o fill=red skin=s { path \"M 20 70 L 40 70\"; weights mean }")
              .ends_with("1:1 warning: 1 point of this object lies in no region of a bone, at 40, 70; the "
                         "nearest bone takes it (let a bone have a larger region=…, or give weights)"));
}

TEST_CASE("the closing point of a stroke follows its first")
{
    CHECK(skin_read("object o fill=red skin=s { rect 18 58 4 4\nweights {\n"
                    "points 1 2 { a 1 }; points 3 4 { b 1 }\n} }") == "a a b b a");
}

TEST_CASE("text is bound as other shapes are")
{
    const std::string points =
        skin_read("object o stroke=red skin=s bone=b { text I at=\"20,60\" size=20 font=hershey-sans }");
    CHECK(points == "b b");
}

TEST_CASE("one bone carries a whole object")
{
    CHECK(skin_read("object o fill=red skin=s bone=b { path \"M 20 70 L 15 60 25 45\" }") == "b b b");
    CHECK(skin_read("object o fill=red skin=s bone=c { path \"M 20 70 L 15 60\" }") ==
          "1:31 error: unknown bone \"c\" (allowed: a, b)");
    CHECK(skin_read("object o fill=red skin=s bone=b { path \"M 20 70 L 15 60\"; weights auto }") ==
          "1:59 error: both bone= and weights say what carries the object (leave it to one of them)");
}

TEST_CASE("some bones carry an object by their regions")
{
    const auto object = [](const std::string& properties) {
        return skin_read("object o fill=red skin=s " + properties);
    };
    const std::string path = " { path \"M 20 70 L 24 46 40 40\" }";
    CHECK(object(path) == "a a|b:94 b");
    CHECK(object("bones=\"a b\"" + path) == "a a|b:94 b");
    CHECK(object("bones=\" b  a \"" + path) == "a a|b:94 b");
    CHECK(object("bones=b { path \"M 40 40 L 24 46\"; weights mean }") == "b b");
    CHECK(object("bones=a { path \"M 20 70 L 40 40\" }")
              .starts_with("a a\n1:1 warning: 1 point of this object"));
    CHECK(object("bones=\"a c\"" + path) == "1:32 error: unknown bone \"c\" (allowed: a, b)");
    CHECK(object("bones=\"a b a\"" + path) == "1:32 error: \"a\" stands here twice (remove one of them)");
    CHECK(object("bones=\" \"" + path) == "1:32 error: no bone is named here (write bones=\"NAME NAME\")");
    CHECK(object("bones=\"a b\" bone=b" + path) ==
          "1:32 error: both bone= and bones= say what carries the object (leave it to one of them)");
    CHECK(object("bones=\"a b\" { path \"M 20 70 L 24 46\"; weights { a 1 } }") ==
          "1:64 error: both bones= and weights say what carries the object (leave it to one of them)");
}

TEST_CASE("what drawings change turns with the bones where the object says so")
{
    const auto turns_changes = [](const std::string& properties) {
        const auto text = read_on_canvas("bones s { bone a 0 0 9 0 }\nobject o fill=red skin=s " +
                                         properties + " { rect 0 0 9 9 }");
        return object_at(*text.scene).skin.value().turns_changes;
    };
    CHECK(!turns_changes(""));
    CHECK(!turns_changes("change=canvas"));
    CHECK(turns_changes("bone=a change=bones"));
    CHECK(read_on_canvas("object o fill=red change=bones { rect 0 0 9 9 }").findings ==
          "3:19 warning: change does nothing without a skin (add skin=… or remove change)");
}

TEST_CASE("weights are given for all points")
{
    const auto object = [](const std::string& weights) {
        return skin_read("object o fill=red skin=s { path \"M 20 70 L 15 60\"\nweights " + weights + " }");
    };
    CHECK(object("{ a 1; b 3 }") == "b|a:64 b|a:64");
    CHECK(object("{ a 1; b 0 }") == "a a");
    CHECK(object("{ a 1; c 3 }") == "2:16 error: unknown bone \"c\" (allowed: a, b)");
    CHECK(object("{ a -1; b 3 }") == "2:13 error: this number is out of range (allowed: 0 to 1000)");
    CHECK(object("{ a 0; b 0 }") ==
          "2:1 error: these weights add up to nothing (give a bone a weight above 0)");
    CHECK(object("{ a 1; a 1 }") == "2:16 error: \"a\" has a weight already (remove one of them)");
    CHECK(object("{ a }") == "2:11 error: a needs more values (write BONE WEIGHT)");
    CHECK(object("evenly") == "2:9 error: unknown value \"evenly\" (allowed: auto, mean)");
    const std::string either = "2:1 error: weights are either a word or those of bones (write weights auto, "
                               "weights mean, or weights { BONE WEIGHT })";
    CHECK(object("") == either);
    CHECK(object("auto { a 1 }") == either);
    CHECK(object("{ a 1 }; weights auto") == "2:18 error: this object has weights already, on line 5");
}

TEST_CASE("weights are given for points, counted through the strokes")
{
    const auto object = [](const std::string& weights) {
        return skin_read("object o fill=red skin=s { path \"M 20 70 L 15 60\"; line 20 60 25 60 25 62\n"
                         "weights {\n" +
                         weights + "\n} }");
    };
    CHECK(object("points 1 3 { a 1 }; points 4 { a 1; b 1 }; points 5 { b 1 }") == "a a a a|b:128 b");
    CHECK(object("points 1 2 { a 1 }; points 5 { a 1 }") ==
          "2:1 error: 2 points without weights; the first is point 3, at 20, 60 (add points 3 { BONE WEIGHT "
          "})");
    CHECK(object("points 1 5 { a 1 }; points 5 { a 1 }") ==
          "3:21 error: point 5 has weights already, on line 6");
    CHECK(object("points 1 6 { a 1 }") == "3:10 error: this number is out of range (allowed: 1 to 5)");
    CHECK(object("points 0 { a 1 }") == "3:8 error: this number is out of range (allowed: 1 to 5)");
    CHECK(object("points 3 2 { a 1 }") ==
          "3:1 error: the first of these points comes behind the last (exchange the numbers)");
    CHECK(object("points 1 5 { a 1 }; b 1") ==
          "3:21 error: weights are either those of all points, or of some points each (put it into braces: "
          "points FIRST LAST { BONE WEIGHT })");
    CHECK(object("points 1 5") ==
          "3:1 error: these weights add up to nothing (give a bone a weight above 0)");
}

TEST_CASE("a point follows at most four bones")
{
    CHECK(read_on_canvas("bones s { bone a 0 0 9 0; bone b 0 1 9 1; bone c 0 2 9 2; bone d 0 3 9 3\n"
                         "bone e 0 4 9 4 }\nobject o fill=red skin=s { line 0 0 9 0\n"
                         "weights { a 1; b 1; c 1; d 1; e 1 } }")
              .findings == "6:31 error: a point follows at most 4 bones");
}

TEST_CASE("bones and weights need a skin, and a skin a skeleton")
{
    const std::string hint = " (add skin=NAME to the object, with the name of a skeleton)";
    CHECK(skin_read("object o fill=red bone=a { line 0 0 9 0; weights auto }")
              .ends_with("\n1:24 error: a bone carries only an object that has a skin" + hint +
                         "\n1:42 error: weights need a skin" + hint));
    CHECK(skin_read("object o fill=red skin=t { line 0 0 9 0 }") ==
          "0:1 warning: the skeleton \"s\" carries nothing (add skin=s to an object, or remove it)\n"
          "1:24 error: unknown skeleton \"t\" (allowed: s)");
    CHECK(read_on_canvas("object o fill=red skin=t { line 0 0 9 0 }").findings ==
          "3:24 error: unknown skeleton \"t\" (write it on the outermost level: bones NAME { … })");
}

TEST_CASE("all drawings of a skin have as many strokes as the first")
{
    const auto object = [](const std::string& keys) {
        return skin_read("object o fill=red skin=s bone=a {\n" + keys + "\n}");
    };
    CHECK(object("key 0 { empty }; key 1 { line 0 0 9 0 }; key 2 { line 0 0 9 0 5 5 }; key 3 { empty }") ==
          "a a");
    CHECK(
        object("key 0 { line 0 0 9 0 }; key 1 { line 0 0 9 0; line 0 9 9 9 }") ==
        "2:25 error: with a skin, all drawings have as many strokes as the first: 1, not 2 (draw it with as "
        "many, or put some strokes into another object)");
    CHECK(object("key 0 match=length { line 0 0 9 0 }; key 1 { line 0 0 9 0 5 5 }") ==
          "2:1 error: match=length does not work with a skin (use match=count)");
}

TEST_CASE("with a skin, a symbol is copied to where its use says")
{
    const std::string skeleton = "bones s { bone a 20 80 20 40 }\n";
    const auto text = read_on_canvas(skeleton + "symbol bar { line 0 0 0 10 }\n"
                                                "object o stroke=red skin=s { use bar 20 50 }");
    REQUIRE(text.scene);
    CHECK(text.findings == "");
    CHECK(text_of(key_at(*text.scene).drawing) == "M 20 50 L 20 60");
    CHECK(object_at(*text.scene).skin->bindings.size() == 2);
    CHECK(read_on_canvas(skeleton + "symbol bar { key 0 { line 0 0 0 10 } }\n"
                                    "object o stroke=red skin=s { use bar 20 50 }")
              .findings ==
          "5:34 error: the symbol \"bar\" has keys, which do not fit here (let its use be all "
          "that an object without skin draws, or use one without keys)");
}
}
