#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// A group with this inside, and what was found; column 1 of line 2 is its first character.
std::string group(const std::string& inside)
{
    return items_read("group {\n" + inside + "\nobject o fill=red { rect 0 0 2 2 } }");
}

/// What group() gives for tracks alone.
std::string with(const std::string& tracks) { return "group " + tracks + "\n  object o @0"; }

}

TEST_CASE("an item goes along a path evenly, or by laws")
{
    CHECK(group("track along \"M 20 20 L 80 20\" { at 60 1; at 0 0 }") ==
          with("along[0:0 60:65536] path(M 20 20 L 80 20)"));
    CHECK(group("track along \"M0 0c1 2 3 4 5 6z\" turn=#true law=ease { at 0 0.25; at 9 0.5 law=hold; at 12 "
                "1 }") == with("along[0:16384(bezier,bezier) 9:32768(hold,hold) 12:65536] "
                               "turning(M 0 0 C 1 2 3 4 5 6 L 0 0)"));
    CHECK(group("track along \"M0 0L9 0\" turn=#false { at 0 0 }") == with("along[0] path(M 0 0 L 9 0)"));
}

TEST_CASE("the pivot is what goes along the path")
{
    CHECK(
        items_read("object o fill=red {\nrect 10 20 30 40; track along \"M0 0L9 0\" { at 0 0; at 9 1 } }") ==
        "object o @0 pivot_x[400] pivot_y[640] along[0:0 9:65536] path(M 0 0 L 9 0)");
    CHECK(items_read("use s pivot-x=3 { track along \"M0 0L9 0\" { at 0 0 } }\n"
                     "symbol s { object o fill=red { rect 0 0 2 2 } }") ==
          "use s pivot_x[48] along[0] path(M 0 0 L 9 0)");
}

TEST_CASE("a path is one stroke that leads somewhere")
{
    CHECK(group("track along { at 0 1 }") ==
          "2:1 error: track needs more values (write track along \"M …\" { at TIME SHARE })");
    CHECK(group("track along 5 { at 0 1 }") == "2:13 error: a word or a text in quotes is expected here");
    CHECK(group("track along \"M0 0L9 0\" 4 { at 0 1 }") ==
          "2:24 error: this value is too many for track (write track along \"M …\" { at TIME SHARE })");
    CHECK(group("track along \"M0 0L9 0M1 1L2 2\" { at 0 1 }") ==
          "2:13 error: an item follows one stroke; this path has 2 "
          "(leave out all M but the first, and what is behind Z)");
    const std::string error = "2:13 error: this path leads nowhere (write one such as \"M 20 20 L 80 20\")";
    CHECK(group("track along \"M5 5Z\" { at 0 1 }") == error);
    CHECK(group("track along \"M5 5l0.01 0.01\" { at 0 1 }") == error);
    CHECK(group("track along \"\" { at 0 1 }") == "2:13 warning: this path draws nothing\n" + error);
    CHECK(group("track along \"M0 0 L9\" { at 0 1 }").starts_with("2:21 error: a number is expected here"));
}

TEST_CASE("shares of a path are 0 to 1, and turn is a truth")
{
    CHECK(group("track along \"M0 0L9 0\" { at 0 1.1 }") ==
          "2:31 error: this number is out of range (allowed: 0 to 1)");
    CHECK(group("track along \"M0 0L9 0\" turn=1 { at 0 1 }") ==
          "2:29 error: #true or #false is expected here");
    CHECK(group("track x turn=#true { at 0 1 }") ==
          "2:9 error: track has no property \"turn\" (allowed: law, input)");
}

TEST_CASE("with a path, nothing else says where an item is")
{
    const auto both = [](const std::string& name, const std::string& giver) {
        return " error: the path says where the item is, but " + name + " is given by " + giver +
               " (leave it out, or put the item into a group that moves)";
    };
    const std::string along = "track along \"M0 0L9 0\" { at 0 0 }";
    CHECK(group(along + "\nkey 0 y=1") == "2:1" + both("y", "the key on line 5"));
    CHECK(group(along + "\ntrack x { at 0 1 }") == "2:1" + both("x", "the track on line 5"));
    CHECK(items_read("object o fill=red y=0 { rect 0 0 2 2; " + along + " }") ==
          "1:39" + both("y", "its item"));
    CHECK(group(along + "\n" + along) == "3:1 error: along is given twice: by this track, and by the track "
                                         "on line 4 (leave it to one of them)");
    CHECK(group(along + "\ntrack z { at 0 1 }") == with("z~[16] along[0] path(M 0 0 L 9 0)"));
}

}
