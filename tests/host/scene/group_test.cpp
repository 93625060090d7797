#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

std::string nested(int groups)
{
    std::string text = "object o fill=red { rect 0 0 1 1 }";
    for (int i = 0; i < groups; ++i)
        text = "group { " + text + " }";
    return text;
}

}

TEST_CASE("groups hold items in their order, with names or without")
{
    CHECK(items_read("object a fill=red { rect 0 0 1 1 }\n"
                     "group face x=10 {\n"
                     "  object b fill=red { rect 0 0 1 1 }\n"
                     "  group { object c fill=red { rect 0 0 1 1 } }\n"
                     "  key 5 x=20\n"
                     "  object d fill=red { rect 0 0 1 1 }\n"
                     "}\n"
                     "group face { object e fill=red { rect 0 0 1 1 } }") == "object a @0\n"
                                                                             "group face x[5:320]\n"
                                                                             "  object b @0\n"
                                                                             "  group\n"
                                                                             "    object c @0\n"
                                                                             "  object d @0\n"
                                                                             "group face\n"
                                                                             "  object e @0");
}

TEST_CASE("groups lie at most 8 deep")
{
    CHECK(items_read(nested(8)).ends_with("object o @0"));
    CHECK(items_read(nested(9)) == "1:65 error: groups and uses lie at most 8 deep in each other");
    CHECK(items_read(nested(200)) == "1:65 error: groups and uses lie at most 8 deep in each other");
}

TEST_CASE("a group with mistakes")
{
    CHECK(items_read("group") == "1:1 error: this group holds nothing (add { object NAME … })");
    CHECK(items_read("group g { key 0 x=1 }") ==
          "1:1 error: this group holds nothing (add { object NAME … })");
    CHECK(items_read("group a b { object o fill=red { rect 0 0 1 1 } }") ==
          "1:9 error: this value is too many for group (write group NAME { items })");
    CHECK(items_read("group 7 { object o fill=red { rect 0 0 1 1 } }") ==
          "1:7 error: a word or a text in quotes is expected here");
    CHECK(items_read("group \"\" { object o fill=red { rect 0 0 1 1 } }") ==
          "1:7 error: a name cannot be empty");
    CHECK(items_read("group { circle 1 1 r=1 }") ==
          "1:9 error: a group has no node \"circle\" (allowed: object, group, use, key, track)");
    CHECK(items_read("group { objekt o }") ==
          "1:9 error: a group has no node \"objekt\" (did you mean \"object\"?)");
}

TEST_CASE("names of objects are told apart wherever they are")
{
    CHECK(items_read("object o fill=red { rect 0 0 1 1 }\n"
                     "group { object o fill=red { rect 0 0 1 1 } }\n"
                     "use s\nsymbol s { object o fill=red { rect 0 0 1 1 } }") ==
          "2:9 error: there is an object \"o\" already, on line 3\n"
          "4:12 error: there is an object \"o\" already, on line 3");
}

TEST_CASE("keys behind the end of the scene are warned of in groups, too")
{
    CHECK(read("kfast 1\ncanvas 9 9 frames=10\ngroup { object a fill=red { rect 0 0 1 1 }\n"
               "key 9 x=0\nkey 10 x=1\nkey 11 x=2\n}")
              .findings == "6:1 warning: the scene ends before anything of this key is seen "
                           "(make the scene longer with frames=… or remove the key)");
}

}
