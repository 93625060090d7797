#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>
#include <sstream>

namespace kfast::test {
namespace {

const std::string spin = " { object o fill=red { rect 0 0 2 2; key 0 x=0; key 8 x=9 } }\n";
const std::string morph = " { key 0 { rect 0 0 2 2 }; key 6 { circle 1 1 r=3 } }\n";

std::string clock_text(const Clock& clock)
{
    std::ostringstream out;
    if (clock.driver.is_clock())
        out << 'c' << clock.driver.index() << ' ';
    out << clock.delay.ticks / 1024.0 << " x" << static_cast<double>(clock.speed) / Clock::normal_speed
        << ' ';
    out << (clock.loop == Loop::once ? "once" : clock.loop == Loop::repeat ? "repeat" : "ping-pong");
    if (clock.length != Time{})
        out << ' ' << clock.length.ticks / 1024.0;
    return out.str();
}

/// The clocks of a scene, then its symbols and by which clock the first object of each goes, then what was
/// found.
std::string clocks_read(const std::string& text)
{
    const SceneText read = read_on_canvas(text);
    const auto& scene = read.scene;
    const std::string& findings = read.findings;
    std::string all;
    if (scene) {
        for (const Clock& clock : scene->clocks)
            all += clock_text(clock) + '\n';
        for (const scene::Symbol& symbol : scene->symbols) {
            const Driver driver = std::holds_alternative<scene::Object>(symbol.items[0].content)
                                      ? symbol.items[0].tracks[0].driver
                                      : Driver{};
            all += symbol.name + (driver.is_clock() ? " by " + std::to_string(driver.index()) : "") + '\n';
        }
    }
    return all + findings;
}

double length_read(const std::string& text)
{
    return read_on_canvas(text).scene.value().length.ticks / 1024.0;
}

}

TEST_CASE("uses have a delay, a speed and what happens at their end")
{
    CHECK(clocks_read("use s\nsymbol s" + spin) == "s\n");
    CHECK(clocks_read("use s delay=5\nsymbol s" + spin) == "5 x1 once\ns by 0\n");
    CHECK(clocks_read("use s delay=(s)-0.5\nsymbol s" + spin) == "-15 x1 once\ns by 0\n");
    CHECK(clocks_read("use s speed=0.5 loop=ping-pong\nsymbol s" + spin) == "0 x0.5 ping-pong 8\ns by 0\n");
    CHECK(clocks_read("use s speed=-2\nsymbol s" + spin) == "0 x-2 once 8\ns by 0\n");
}

TEST_CASE("symbols have a length of their own, after which they repeat")
{
    CHECK(clocks_read("use s\nsymbol s frames=20" + spin) == "0 x1 repeat 20\ns by 0\n");
    CHECK(clocks_read("use s loop=once\nsymbol s frames=20" + spin) == "0 x1 once 20\ns by 0\n");
    CHECK(clocks_read("use s\nsymbol s loop=ping-pong" + spin) == "0 x1 ping-pong 8\ns by 0\n");
    CHECK(clocks_read("use s loop=repeat\nsymbol s frames=(s)1 loop=once" + spin) ==
          "0 x1 repeat 30\ns by 0\n");
}

TEST_CASE("a symbol is stored once for each time that it goes by")
{
    CHECK(clocks_read("use s\nuse s delay=2\nuse s 5 5 delay=2\nuse s delay=3\nsymbol s" + spin) ==
          "2 x1 once\n3 x1 once\ns\ns by 0\ns by 1\n");
    CHECK(clocks_read("use t delay=2\nuse t\nsymbol t { use s delay=1 }\nsymbol s" + spin) ==
          "2 x1 once\nc0 1 x1 once\n1 x1 once\ns by 1\nt\ns by 2\nt\n");
}

TEST_CASE("an object goes by the time of the drawing that it uses, its own keys by that of the scene")
{
    const SceneText read = read_on_canvas(
        "object o fill=red { use m 4 4 loop=repeat; key 0 opacity=0; key 9 opacity=1 }\nsymbol m" + morph);
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    const scene::Scene& scene = *read.scene;
    CHECK(object_at(scene).driver == Driver::of_clock(0));
    CHECK(scene.clocks.at(0).length == Time::frame(6));
    for (const scene::Track& track : scene.items[0].tracks)
        CHECK(track.driver.is_time());
}

TEST_CASE("a scene without frames lasts for one pass of what it uses")
{
    CHECK(length_read("use s\nsymbol s" + spin) == 8);
    CHECK(length_read("use s delay=4\nsymbol s" + spin) == 12);
    CHECK(length_read("use s delay=4 speed=-0.5\nsymbol s frames=20" + spin) == 44);
    CHECK(length_read("use s\nsymbol s frames=5" + spin) == 5);
    CHECK(length_read("use s speed=\"1/3\"\nsymbol s frames=30" + spin) == 90);
    CHECK(length_read("use s speed=0.7 delay=2\nsymbol s frames=21" + spin) == 32);
    CHECK(length_read("use s delay=-50\nsymbol s" + spin) == 1);
}

TEST_CASE("keys beyond the length of their symbol are warned of, not those beyond the scene's")
{
    CHECK(read("kfast 1\ncanvas 9 9 frames=4\nuse s\nsymbol s frames=20" + spin).findings.empty());
    CHECK(read("kfast 1\ncanvas 9 9 frames=40\nuse s\nsymbol s frames=6 { object o fill=red { rect 0 0 2 2; "
               "key 0 x=0;"
               " key 7 x=1; key 8 x=9 } }")
              .findings.find("the symbol ends before anything of this key is seen") != std::string::npos);
}

TEST_CASE("keys beyond the scene are warned of in symbols that go by its time wherever they are used")
{
    const auto findings = [](const std::string& uses) {
        return read("kfast 1\ncanvas 9 9 frames=6\n" + uses + "\nsymbol s" + spin).findings;
    };
    const std::string late = "the scene ends before anything of this key is seen";
    CHECK(findings("use s\nuse s 1 1").find(late) == std::string::npos); // the last key still shapes it
    const auto with_late_key = [&](const std::string& uses) {
        return read("kfast 1\ncanvas 9 9 frames=6\n" + uses +
                    "\nsymbol s { object o fill=red { rect 0 0 2 2; key 0 x=0; key 7 x=1; key 8 x=9 } }")
            .findings;
    };
    CHECK(with_late_key("use s").find(late) != std::string::npos);
    CHECK(with_late_key("use s\nuse s speed=4").empty());
    CHECK(with_late_key("use s delay=-5").empty());
    CHECK(with_late_key("use t\nsymbol t frames=20 { use s }").empty());
    CHECK(with_late_key("use t speed=-2\nsymbol t { use s }").empty());
    CHECK(with_late_key("use t\nsymbol t { use s }").find(late) != std::string::npos);
}

TEST_CASE("a use that begins when the scene has ended is warned of")
{
    const auto findings = [](const std::string& delay) {
        return read("kfast 1\ncanvas 9 9 frames=6\nuse s delay=" + delay + "\nsymbol s" + spin).findings;
    };
    CHECK(findings("5").empty());
    CHECK(findings("6") ==
          "3:1 warning: the scene ends before this use of a symbol begins (make the scene longer "
          "with frames=… or the delay shorter)");
}

TEST_CASE("a use at the time around it needs no time of its own, whatever it says")
{
    CHECK(clocks_read("use s delay=0 speed=1 loop=once\nsymbol s" + spin) == "s\n");
}

TEST_CASE("what is wrong with a time of its own is told")
{
    const std::string symbol = "\nsymbol s" + spin;
    CHECK(clocks_read("use s speed=0" + symbol) ==
          "3:13 error: at this speed nothing moves (leave out speed=… or write another number)");
    CHECK(clocks_read("use s speed=17" + symbol) ==
          "3:13 error: this number is out of range (allowed: -16 to 16)");
    CHECK(clocks_read("use s delay=1000001" + symbol) ==
          "3:13 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(clocks_read("use s loop=twice" + symbol).starts_with("3:12 error: unknown value"));
    CHECK(clocks_read("use s loop=repeat\nsymbol s { object o fill=red { rect 0 0 2 2 } }") ==
          "3:1 error: the symbol \"s\" has no length: it has no key after its beginning (give it one with "
          "frames=…)");
    CHECK(clocks_read("use s\nsymbol s frames=0" + spin)
              .starts_with("4:17 error: a symbol with a time of its own cannot have the length 0"));
    CHECK(
        clocks_read("object o fill=red { use d delay=1; circle 5 5 r=2 }\nsymbol d { rect 0 0 2 2 }") ==
        "3:25 error: the symbol \"d\" has no keys, which a time moves (leave out delay=, speed= and loop=)");
}

TEST_CASE("there are at most 223 different times of their own")
{
    const auto uses = [](int count) {
        std::string text = "symbol s" + spin;
        for (int i = 1; i <= count; ++i)
            text += "use s delay=" + std::to_string(i) + '\n';
        return read_on_canvas(text).findings;
    };
    CHECK(uses(223).empty());
    CHECK(uses(224) ==
          "227:1 error: a scene holds at most 223 different times of their own (let uses have the "
          "same delay, speed and loop)");
}

}
