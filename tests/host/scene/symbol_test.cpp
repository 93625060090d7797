#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

const std::string box = "{ rect 0 0 2 2 }";

/// The names of a scene's symbols, and the items of each.
std::string symbols_read(const std::string& text)
{
    const auto [scene, findings] = read_on_canvas(text);
    std::string all;
    if (scene)
        for (const scene::Symbol& symbol : scene->symbols)
            all += symbol.name + ": " + text_of(*scene, symbol.items) + '\n';
    return all + findings;
}

/// s1 uses s2, which uses s3 … The last one is `last`.
std::string chain(int count, const std::string& last)
{
    std::string text;
    for (int i = 1; i < count; ++i)
        text += "symbol s" + std::to_string(i) + " { use s" + std::to_string(i + 1) + " }\n";
    return text + "symbol s" + std::to_string(count) + ' ' + last;
}

}

TEST_CASE("symbols of items are stored once, each behind those that it uses")
{
    const std::string text = "use two\nuse face\n"
                             "symbol two { use face; group { use face 40 0 } }\n"
                             "symbol face { object o fill=red " +
                             box + "; use nose }\nsymbol nose { object n fill=blue " + box + " }";
    CHECK(items_read(text) == "use two\nuse face");
    CHECK(symbols_read(text) == "nose: object n @0\n"
                                "face: object o @0\nuse nose\n"
                                "two: use face\ngroup\n  use face x[640]\n");
}

TEST_CASE("a use has a place, properties and keys")
{
    const std::string symbol = "\nsymbol s { object o fill=red " + box + " }";
    CHECK(items_read("use s 10 -2.5 rotate=90 opacity=0" + symbol) ==
          "use s x[160] y[-40] rotation[16384] opacity[0]");
    CHECK(items_read("use s x=3 pivot-x=1 scale=2" + symbol) ==
          "use s x[48] scale_x[8192] scale_y[8192] pivot_x[16]");
    CHECK(items_read("use s { key 0 x=1; key 5 x=2 opacity=0 }" + symbol) ==
          "use s x[0:16 5:32] opacity[0:255 5:0]");
}

TEST_CASE("a mirror changes the sign of a scale and of all that keys make of it")
{
    const std::string symbol = "\nsymbol s { object o fill=red " + box + " }";
    CHECK(items_read("use s mirror=x" + symbol) == "use s scale_x[-4096]");
    CHECK(items_read("use s mirror=y scale=2" + symbol) == "use s scale_x[8192] scale_y[-8192]");
    CHECK(items_read("use s mirror=both scale-x=-1" + symbol) == "use s scale_y[-4096]");
    CHECK(items_read("use s mirror=x { key 0 scale=1; key 9 scale=2 }" + symbol) ==
          "use s scale_x[0:-4096 9:-8192] scale_y[0:4096 9:8192]");
    CHECK(items_read("use s mirror=x { key 0 x=1; key 9 scale-x=3 }" + symbol) ==
          "use s x[16] scale_x[0:-4096 9:-12288]");
    CHECK(items_read("use s mirror=left" + symbol) ==
          "1:14 error: unknown value \"left\" (allowed: x, y, both)");
}

TEST_CASE("a use with mistakes")
{
    const std::string symbol = "\nsymbol eye { object o fill=red " + box + " }\nuse eye";
    const auto errors = [&](const std::string& use) { return items_read(use + symbol); };
    CHECK(errors("use") == "1:1 error: use needs more values (write use SYMBOL X Y)");
    CHECK(errors("use eye 1") == "1:9 error: this x has no y (write use SYMBOL X Y)");
    CHECK(errors("use eye 1 2 3") == "1:13 error: this value is too many for use (write use SYMBOL X Y)");
    CHECK(errors("use eye 1 up") == "1:11 error: a number is expected here");
    CHECK(errors("use eye 1 2 x=3") ==
          "1:13 error: x is given twice (leave out x=… or the numbers behind the symbol)");
    CHECK(errors("use eye 1 2 y=3") ==
          "1:13 error: y is given twice (leave out y=… or the numbers behind the symbol)");
    CHECK(errors("use eie") == "1:5 error: unknown symbol \"eie\" (did you mean \"eye\"?)");
    CHECK(errors("use nothing") == "1:5 error: unknown symbol \"nothing\" (allowed: eye)");
    CHECK(errors("use 7") == "1:5 error: a word or a text in quotes is expected here");
    CHECK(errors("use eye { circle 1 2 r=3 }") ==
          "1:11 error: a use has no node \"circle\" (allowed: key, track)");
    CHECK(errors("use eye fill=red").starts_with("1:9 error: use has no property \"fill\""));
    CHECK(items_read("use x") ==
          "1:5 error: unknown symbol \"x\" (write it on the outermost level: symbol NAME { … })");
}

TEST_CASE("symbols stand on the outermost level, each name once")
{
    CHECK(items_read("use a\nsymbol a { object o fill=red " + box + " }\nsymbol a " + box) ==
          "3:1 error: there is a symbol \"a\" already, on line 4");
    CHECK(items_read("group { symbol a " + box + " }")
              .starts_with("1:9 error: a group has no node \"symbol\""));
    CHECK(items_read("symbol " + box) ==
          "1:1 error: symbol needs more values (write symbol NAME { items, shapes or keys })");
    CHECK(items_read("symbol a x=1 " + box) ==
          "1:1 warning: the symbol \"a\" is not used (use it, or remove it)\n"
          "1:10 error: symbol has no property \"x\" (allowed: frames, loop)");
    CHECK(items_read("symbol \"\" " + box) == "1:8 error: a name cannot be empty");
}

TEST_CASE("a symbol that is not used is warned of, and read all the same")
{
    CHECK(items_read("symbol a { use b }\nsymbol b { object o fill=red " + box + " }") ==
          "1:1 warning: the symbol \"a\" is not used (use it, or remove it)");
    CHECK(items_read("symbol b { object o fill=red " + box + " }\nsymbol a { use b }") ==
          "2:1 warning: the symbol \"a\" is not used (use it, or remove it)");
    CHECK(symbols_read("symbol a " + box) ==
          "3:1 warning: the symbol \"a\" is not used (use it, or remove it)");
    CHECK(items_read("symbol a { circel 1 2 r=3; circle 1 1 r=2 }")
              .starts_with("1:1 warning: the symbol \"a\" is not used (use it, or remove it)\n"
                           "1:12 error: a symbol has no node \"circel\" (did you mean \"circle\"?)"));
    // Nothing of it belongs to the scene.
    const auto scene = read_on_canvas("symbol a { object o fill=red { key 90 { empty } } }").scene;
    REQUIRE(scene);
    CHECK(scene->length == Time::frame(1));
    CHECK(scene->palette.size() == 1);
    CHECK(scene->symbols.empty());
}

TEST_CASE("a symbol holds either items or a drawing")
{
    CHECK(items_read("use a\nsymbol a { object o fill=red " + box + "; rect 0 0 1 1 }") ==
          "2:48 error: a symbol holds either items or a drawing, not both "
          "(put shapes and keys into an object of the symbol)");
    CHECK(items_read("use a\nsymbol a { key 0 { empty }; group { object o fill=red " + box + " } }") ==
          "1:5 error: the symbol \"a\" is a drawing (put its use into an object, which gives it a colour)\n"
          "2:29 error: a symbol holds either items or a drawing, not both "
          "(put shapes and keys into an object of the symbol)");
    CHECK(items_read("use a\nsymbol a { group { object o fill=red " + box + " }; objekt x }") ==
          "2:58 error: a symbol has no node \"objekt\" (did you mean \"object\"?)");
    CHECK(items_read("use a\nsymbol a") == "2:1 error: this symbol holds nothing (add objects, or shapes)");
    CHECK(items_read("use a\nsymbol a { key 0 { line 0 0 1 1 }; line 0 0 1 1 }")
              .ends_with("2:36 error: a symbol has its drawings either in keys or without, not both "
                         "(put the shapes into a key: key 0 { … })"));
}

TEST_CASE("a symbol is used where its kind fits")
{
    CHECK(items_read("use a\nsymbol a " + box) ==
          "1:5 error: the symbol \"a\" is a drawing (put its use into an object, which gives it a colour)");
    CHECK(items_read("object o fill=red { use a }\nsymbol a { object p fill=red " + box + " }") ==
          "1:25 error: the symbol \"a\" holds items, no drawing (use it beside objects, not inside one)");
    CHECK(items_read("object o fill=red { use a; use b 1 1 }\nsymbol a { line 0 0 1 1 }\n"
                     "symbol b { key 0 { empty } }") ==
          "1:32 error: the symbol \"b\" has keys, which do not fit here "
          "(let its use be all that an object without skin draws, or use one without keys)");
    CHECK(items_read("object o fill=red { use b count=4 }\nsymbol b { key 0 { empty } }") ==
          "1:25 error: the symbol \"b\" has keys, and there are no copies of such a drawing "
          "(leave out count=, draw the symbol without keys, or let it hold an object)");
    // One that only uses others is what they are.
    CHECK(items_read("object o fill=red { use a }\nsymbol a { use b }\nsymbol b { use c }\nsymbol c " +
                     box) == "object o @0");
    CHECK(items_read("use a\nsymbol a { use b; use c }\nsymbol b { object o fill=red " + box +
                     " }\nsymbol c " + box) ==
          "2:23 error: the symbol \"c\" is a drawing (put its use into an object, which gives it a colour)");
}

TEST_CASE("a symbol that uses itself is refused, with the chain")
{
    CHECK(items_read("use a\nsymbol a { use a }") == "2:16 error: the symbol \"a\" uses itself (a → a)");
    CHECK(items_read("use a\nsymbol a { group { use b } }\nsymbol b { use c }\nsymbol c { use b 1 1 }") ==
          "4:16 error: the symbol \"b\" uses itself (b → c → b)");
    CHECK(
        items_read("object o fill=red { use a }\nsymbol a { line 0 0 1 1; use b }\nsymbol b { use a; empty }")
            .starts_with("3:16 error: the symbol \"a\" uses itself (a → b → a)"));
}

TEST_CASE("the ways through symbols count for the depth")
{
    const std::string object = "{ object o fill=red " + box + " }";
    CHECK(items_read("use s1\n" + chain(8, object)) == "use s1");
    CHECK(items_read("use s1\n" + chain(9, object)) ==
          "1:1 error: groups and uses lie at most 8 deep in each other");
    CHECK(items_read("group { use s1 }\n" + chain(8, object)) ==
          "1:9 error: groups and uses lie at most 8 deep in each other");
    CHECK(items_read("use s1\n" + chain(8, "{ group " + object + " }")) ==
          "1:1 error: groups and uses lie at most 8 deep in each other");
    CHECK(items_read("use s1\n" + chain(5'000, object)) ==
          "1:1 error: groups and uses lie at most 8 deep in each other\n"
          "10:17 error: groups and uses lie at most 8 deep in each other");
    CHECK(items_read("object o fill=red { use s1 }\n" + chain(9, box)) == "object o @0");
    CHECK(items_read("object o fill=red { use s1 }\n" + chain(10, box)) ==
          "10:17 error: groups and uses lie at most 8 deep in each other");
    // However much of the chain has been read before.
    CHECK(items_read("object p fill=red { use s2 }\nobject o fill=red { use s1 }\n" + chain(10, box)) ==
          "3:17 error: groups and uses lie at most 8 deep in each other");
}

TEST_CASE("an object can take a whole symbol, and stands where its use says")
{
    const std::string blink = "\nsymbol blink { key 0 law=accelerate { rect 2 2 4 4 }; key 5 { empty } }";
    const auto [scene, findings] =
        read_on_canvas("object o fill=red { use blink 70 120 rotate=90 scale=2 mirror=x }" + blink);
    REQUIRE(scene);
    CHECK(findings == "");
    CHECK(text_of(*scene, scene->items) ==
          "object o @0,5 x[1120] y[1920] rotation[16384] scale_x[-8192] scale_y[8192]");
    CHECK(text_of(key_at(*scene).drawing) == "M 2 2 L 6 2 L 6 6 L 2 6 L 2 2");
    CHECK(key_at(*scene).laws.x == VelocityLaw::accelerate);
    CHECK(scene->symbols.empty());
    CHECK(items_read("object o fill=red { use blink 7 8; key 3 x=1; key 6 opacity=0 }" + blink) ==
          "object o @0,5 x[3:16] y[128] opacity[3:255 6:0]");
    CHECK(items_read("object o fill=red scale=2 { use blink mirror=x; key 0 rotate=0; key 6 rotate=9 }" +
                     blink) == "object o @0,5 rotation[0:0 6:1638] scale_x[-8192] scale_y[8192]");
    CHECK(items_read("object o fill=red pivot-x=3 { use blink rotate=90 }" + blink) ==
          "object o @0,5 rotation[16384] pivot_x[48]");
}

TEST_CASE("an object and the use that it takes do not both give a place")
{
    const std::string symbol = "\nsymbol s " + box;
    CHECK(items_read("object o fill=red x=3 { use s 1 2 }" + symbol) ==
          "1:25 error: both the object and its use give x (leave it to one of them)");
    CHECK(items_read("object o fill=red rotate=3 { use s rotate=2 }" + symbol) ==
          "1:30 error: both the object and its use give rotate (leave it to one of them)");
    CHECK(items_read("object o fill=red scale-x=2 { use s scale=2 }" + symbol) ==
          "1:31 error: both the object and its use give scale-x (leave it to one of them)");
    CHECK(items_read("object o fill=red { use s; key 0 { empty } }" + symbol)
              .ends_with("1:28 error: an object has its drawings either in keys or without, not both "
                         "(put the shapes into a key: key 0 { … })"));
    CHECK(items_read("object o fill=red { use s opacity=1 }" + symbol) ==
          "1:27 error: use has no property \"opacity\" "
          "(allowed: x, y, z, rotate, rotate-x, rotate-y, rotate-z, scale, scale-x, scale-y, mirror, delay, "
          "speed, loop, count, x-step, y-step, rotate-step, scale-step)");
}

TEST_CASE("among shapes a use is a copy, rounded once")
{
    const auto copied = [](const std::string& use, const std::string& symbol) {
        const auto [scene, findings] =
            read_on_canvas("object o fill=red { key 0 { " + use + " } }\nsymbol s { " + symbol + " }");
        return scene ? text_of(key_at(*scene).drawing) : findings;
    };
    CHECK(copied("use s", "line 0 0 4 2") == "M 0 0 L 4 2");
    CHECK(copied("use s 10 20", "line 0 0 4 2") == "M 10 20 L 14 22");
    CHECK(copied("use s 10 20 rotate=90", "line 0 0 4 2") == "M 10 20 L 8 24");
    CHECK(copied("use s rotate=-90", "line 0 0 4 2") == "M 0 0 L 2 -4");
    CHECK(copied("use s scale=2 scale-y=3", "line 0 0 4 2") == "M 0 0 L 8 6");
    CHECK(copied("use s 1 0 mirror=x", "line 0 0 4 2") == "M 1 0 L -3 2");
    CHECK(copied("use s mirror=both scale=2", "line 0 0 4 2") == "M 0 0 L -8 -4");
    CHECK(copied("use s rotate=90 scale-x=2", "line 0 0 4 0") == "M 0 0 L 0 8"); // grows, then turns
    CHECK(copied("use s rotate=45", "line 0 0 4 0") == "M 0 0 L 2.8125 2.8125");
    CHECK(copied("line 9 9 8 8; use s 1 0", "path \"M0 0C1 2 3 4 5 6\"; line 0 0 1 0") ==
          "M 9 9 L 8 8 M 1 0 C 2 2 4 4 6 6 M 1 0 L 2 0");
    CHECK(copied("use s", "polygon 0 0 1 0 1 1") == "M 0 0 L 1 0 L 1 1 L 0 0");
    CHECK(copied("use s", "empty") == "");
    // 0.04 px is nothing at first, and 64 times larger it is 2.56 px.
    CHECK(copied("use s scale=64", "line 0 0 0.02 0.04") == "M 0 0 L 1.25 2.5625");
    CHECK(copied("use s 2000 0", "line 0 0 48 0") ==
          "3:29 error: this use reaches more than 2047 px from the origin");
}

TEST_CASE("copies of copies")
{
    const auto [scene, findings] =
        read_on_canvas("object o fill=red { key 0 { use two 10 0 scale=2; line 0 0 1 1 } }\n"
                       "symbol two { use one; use one 0 5 mirror=x }\nsymbol one { line 1 0 2 0 }");
    REQUIRE(scene);
    CHECK(findings == "");
    CHECK(text_of(key_at(*scene).drawing) == "M 12 0 L 14 0 M 8 10 L 6 10 M 0 0 L 1 1");
}

TEST_CASE("keys of a symbol hold drawings only")
{
    CHECK(items_read("object o fill=red { use s }\nsymbol s { key 0 { empty }; key 3 x=1; key 4 }") ==
          "2:35 error: key has no property \"x\" (allowed: law, law-x, law-y, match)\n"
          "2:40 error: this key sets nothing (add shapes or \"empty\")");
}

}
