#include "host/scene/context/limits.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// What is found in a scene that begins with `lets`, on line 3, and uses the variable a.
std::string defined(const std::string& lets)
{
    return read_on_canvas(lets + "\nobject o fill=red { circle a 9 r=1 }").findings;
}

/// What the drawing `shape` becomes with a=10 and b=0.5, or what is wrong with it, on line 3.
std::string drawn_with(const std::string& shape)
{
    const auto [scene, findings] =
        read_on_canvas("object o fill=red { " + shape + " }\nlet a=10 b=0.5 all=a+b\nevent all*0 used");
    return scene ? test::text_of(key_at(*scene).drawing) + findings : findings;
}

}

TEST_CASE("variables stand for numbers wherever numbers stand")
{
    CHECK(drawn_with("line a a*2 -a \"3-a\"") == "M 10 20 L -10 -7");
    CHECK(drawn_with("line a a+b \"a/4\" \"=a\"") == "M 10 10.5 L 2.5 10");
    CHECK(drawn_with("rect a a a*2 b+1") == "M 10 10 L 30 10 L 30 11.5 L 10 11.5 L 10 10");
    CHECK(drawn_with("polygon 0 0 \"a*cos(60)\" 0 0 \"min(a, 4)\"") == "M 0 0 L 5 0 L 0 4 L 0 0");
}

TEST_CASE("the canvas, times, tracks, laws, poses and places take expressions")
{
    const auto [scene, findings] = read("kfast 1\n"
                                        "let w=40 n=3 t=0.5\n"
                                        "canvas w*2 \"w/2\" fps=n*10 frames=(s)t*4 camera=w+n\n"
                                        "input level min=-w max=w\n"
                                        "bones s {\n"
                                        "bone a 0 w 0 0\n"
                                        "pose \"=t-0.5\" { a turn=n }\n"
                                        "pose (s)t { a turn=w }\n"
                                        "pose n*10 rest\n"
                                        "}\n"
                                        "object o fill=red skin=s bone=a { rect 0 0 9 9 }\n"
                                        "group g {\n"
                                        "object p fill=red { text \"n\" at=\"w/2, w-n\" size=w }\n"
                                        "key (s)t x=w law=\"steps(n)\"\n"
                                        "key (ms)\"t * 2000\" x=-w law=\"bezier(t/2,0,1 - t,1)\"\n"
                                        "key n*20 x=n\n"
                                        "track rotate { at 0 n; at t*8 \"max(w, 90)\" }\n"
                                        "track y input=level law=constant { at -w 0; at \"w / 2\" n }\n"
                                        "}\n"
                                        "clip c from=n to=n+1\n"
                                        "event n c");
    CHECK(findings == "");
    REQUIRE(scene);
    CHECK(scene->canvas.width == 80);
    CHECK(scene->canvas.height == 20);
    CHECK(scene->frame_rate == 30'000);
    CHECK(scene->length == Time::frame(60));
    CHECK(scene->camera == 43);
    CHECK(scene->inputs.front().max == 40'000);
    CHECK(scene->events.front().time == Time::frame(3));
    CHECK(
        test::text_of(*scene, scene->items) ==
        "object o @0\n"
        "group g x[15:640(steps,steps) 30:-640(bezier,bezier) 60:48] y[0:0 48:48] rotation~[0:546 4:16384]\n"
        "  object p @0");
}

TEST_CASE("what only sounds like an expression stays a text")
{
    CHECK(read_on_canvas("let size=9\nobject size fill=red { text \"size*2\" at=\"5,50\" size=size }")
              .findings == "");
    CHECK(read_on_canvas("let red=9\nobject o fill=red { circle red red r=1 }").findings == "");
    CHECK(read("kfast a\nlet a=1\ncanvas a a").findings == "1:7 error: a number is expected here");
    CHECK(drawn_with("path \"M 0 0 L b 4\"").find(" error: a number is expected here (") !=
          std::string::npos);
}

TEST_CASE("a mere word is told of variables where there are some")
{
    CHECK(drawn_with("circle a left r=1") ==
          "3:30 error: a number is expected here, and there is no variable \"left\" (define it: let left=…)");
    CHECK(drawn("circle 1 left r=1") == "1:10 error: a number is expected here");
    CHECK(drawn("circle 1 left*2 r=1") ==
          "1:10 error: a number is expected here, and there is no variable \"left\" (define it: let left=…)");
    CHECK(drawn("circle 1 \"(2+3)*2\" r=1").starts_with("M 2 10 "));
}

TEST_CASE("what is wrong in an expression has its place within the text")
{
    CHECK(drawn_with("circle \"a +\" 2 r=1") ==
          "3:32 error: a value is missing here (write a number, a variable or (…))");
    CHECK(drawn_with("circle a+ 2 r=1") ==
          "3:30 error: a value is missing here "
          "(write a number, a variable or (…); what has blanks in it stands in quotes)");
    CHECK(drawn_with("circle a \"2*\\u{63}\" r=1") ==
          "3:30 error: a number is expected here, and there is no variable \"c\" (line 1, column 3 of the "
          "expression) (define it: let c=…)");
    CHECK(drawn_with("circle a \"10\" r=1") ==
          "3:30 error: a number is expected here (write 10 without quotes)");
    CHECK(drawn_with("text I size=9 at=\"a+c,2\"") ==
          "3:41 error: a number is expected here, and there is no variable \"c\" (define it: let c=…)");
}

TEST_CASE("what comes out is a number like any other")
{
    CHECK(drawn_with("circle a*1000 2 r=1") ==
          "3:28 error: this number is out of range: it comes to 10000 (allowed: -2047 to 2047)");
    CHECK(drawn_with("star a 2 r=1 points=a+b") ==
          "3:41 error: a whole number is expected here: it comes to 10.5 (write \"round(…)\")");
    CHECK(drawn_with("circle (s)a 2 r=1") == "3:28 error: this value takes no type or unit (leave out (s))");
    CHECK(read_on_canvas("let t=1\nevent (h)t e").findings.starts_with("4:7 error: unknown unit \"h\""));
    CHECK(read_on_canvas("let t=1\nevent -t e").findings.starts_with("4:7 error: a time cannot be negative"));
}

TEST_CASE("a variable is defined once, in front of the others that use it")
{
    CHECK(defined("let b=2 a=b*2\nlet c=a\nevent c*0 e") == "");
    CHECK(defined("let a=1\nlet a=2") == "4:5 error: there is a variable \"a\" already, on line 3");
    CHECK(defined("let a=1 a=2") == "3:9 error: there is a variable \"a\" already, on line 3");
    CHECK(defined("let a=b b=1") ==
          "3:7 error: \"b\" is used before its definition (define it in front of this)");
    CHECK(defined("let a=a+1") ==
          "3:7 error: \"a\" is defined by itself (define one of them by numbers alone)");
    CHECK(defined("let a=b b=c c=2*a").empty() == false);
    CHECK(defined("let a=b b=a") ==
          "3:7 error: \"a\" is defined by itself, by way of \"b\" (define one of them by numbers alone)");
}

TEST_CASE("what is wrong with a variable is said once, where it is defined")
{
    CHECK(defined("let a=\"1/0\" b=a*2\nlet c=b") ==
          "3:10 error: this divides by 0 (let it be something else)");
    CHECK(defined("let a=#true") == "3:7 error: a number is expected here");
    CHECK(defined("let a=2e9") ==
          "3:7 error: this number is out of range (allowed: -1000000000 to 1000000000)");
    CHECK(defined("let a=(s)2") ==
          "3:7 error: a variable has no unit (write the unit where it is used: (s)a)");
    CHECK(defined("let a=red") == "3:7 error: a variable is a number, and this is a colour "
                                  "(give it a name in the palette: palette { a \"red\" })");
    CHECK(defined("let a=\"#fff\"").starts_with("3:7 error: a variable is a number, and this is a colour"));
    CHECK(defined("let red=1 a=red") == "");
}

TEST_CASE("a let of another form is refused")
{
    CHECK(read_on_canvas("let").findings == "3:1 error: this let defines nothing (write let NAME=NUMBER)");
    CHECK(read_on_canvas("let a 2").findings ==
          "3:5 error: this value is too many for let (write let NAME=NUMBER)");
    CHECK(read_on_canvas("let a=1 { b }").findings ==
          "3:11 error: let takes no nodes inside (write let NAME=NUMBER)");
    CHECK(read_on_canvas("let ball-size=1").findings ==
          "3:5 error: \"ball-size\" cannot be the name of a variable (write ball_size, for - is minus)");
    CHECK(read_on_canvas("let sin=1").findings == "3:5 error: \"sin\" cannot be the name of a variable "
                                                  "(it has letters, digits and _, and is no function)");
    CHECK(read_on_canvas("let " + std::string(41, 'a') + "=1").findings ==
          "3:5 error: this name is too long (that of a variable has at most 40 letters)");
    CHECK(read_on_canvas("group { let a=1 }").findings.starts_with("3:9 error: a group has no node \"let\""));
    CHECK(read_on_canvas("var a=1").findings ==
          "3:1 error: a scene has no node \"var\" (KFAST calls it \"let\")");
}

TEST_CASE("a variable that nothing uses is a warning")
{
    CHECK(read_on_canvas("let a=1 b=a").findings ==
          "3:9 warning: the variable \"b\" is not used (use it in the place of a number, or remove it)");
    CHECK(read_on_canvas("let a=1\nobject o fill=rd { circle 1 1 r=a }").findings ==
          "4:15 error: unknown colour \"rd\" (did you mean \"red\"?)");
}

TEST_CASE("a scene has as many variables as it may, and no more")
{
    std::string lets = "let a0=1";
    for (std::size_t i = 1; i < scene::max_variables; ++i)
        lets += " a" + std::to_string(i) + "=a" + std::to_string(i - 1) + "+1";
    const std::string use = "\nevent a5 e\nobject o fill=red { circle 1 1 r=a999*0.001; key 9 x=3 }";
    CHECK(read_on_canvas(lets + use).findings == "");
    CHECK(read_on_canvas(lets + " more=1" + use).findings.find("error: a scene has at most 1000 variables") !=
          std::string::npos);
}

}
