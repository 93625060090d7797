#include "host/scene/skeleton/bone_frames.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <sstream>

namespace kfast::test {
namespace {

std::string chain_of(int bones)
{
    std::string text;
    for (int i = 0; i < bones; ++i)
        text += "bone b" + std::to_string(i) + " 0 " + std::to_string(i) + " 5 " + std::to_string(i) + "\n";
    return text;
}

}

TEST_CASE("a bone is stored in the frame of its parent, and level by level")
{
    CHECK(bones_read("bone torso 50 90 50 50 {\n"
                     "bone arm 50 50 70 50 { bone hand 70 50 70 60 }\n"
                     "bone tail 50 80 40 80\n"
                     "}\nbone hat 10 10 20 10") == "torso 49152 800 1440 640\n"
                                                   "hat 0 160 160 160\n"
                                                   "arm <torso tip 16384 640 0 320\n"
                                                   "tail <torso 49152 160 0 160\n"
                                                   "hand <arm tip 16384 320 0 160");
}

TEST_CASE("parents may be told by name, in any order")
{
    CHECK(bones_read("bone hand 70 50 70 60 parent=arm\nbone arm 50 50 70 50 parent=torso\n"
                     "bone torso 50 90 50 50") == "torso 49152 800 1440 640\n"
                                                  "arm <torso tip 16384 640 0 320\n"
                                                  "hand <arm tip 16384 320 0 160");
}

TEST_CASE("a bone that begins at the tip of its parent is fixed to it, unless it says otherwise")
{
    CHECK(bones_read("bone a 0 0 10 0 { bone b 10 0 10 10 tip=#false; bone c 5 0 5 5 tip=#true\n"
                     "bone d 10.03 0.03 10 10; bone e 10.04 0 10 10 }") == "a 0 0 0 160\n"
                                                                           "b <a 16384 160 0 160\n"
                                                                           "c <a tip 16384 80 0 80\n"
                                                                           "d <a tip 16415 160 0 160\n"
                                                                           "e <a 16426 161 0 160");
    CHECK(bones_read("bone a 0 0 10 0 tip=#true") ==
          "a 0 0 0 160\n1:17 warning: tip does nothing without a parent (remove it, or add parent=…)");
}

TEST_CASE("what rounding loses does not add up along a chain")
{
    std::mt19937 random{5};
    std::uniform_real_distribution<double> step{-40, 40};
    std::ostringstream text;
    text.precision(9);
    std::vector<scene::Vec2> spots{{50, 50}};
    for (int i = 0; i < 100; ++i) {
        spots.push_back(i % 2 == 0 ? spots.back() + scene::Vec2{step(random), step(random)}
                                   : scene::Vec2{step(random), step(random)});
        text << "bone b" << i << ' ' << spots[spots.size() - 2].x << ' ' << spots[spots.size() - 2].y << ' '
             << spots.back().x << ' ' << spots.back().y;
        if (i != 0)
            text << " parent=b" << i - 1;
        text << '\n';
    }
    const auto [scene, findings] =
        read_on_canvas("bones s {\n" + text.str() + "}\nobject o fill=red skin=s { empty }");
    REQUIRE(scene);
    const std::vector<scene::BoneFrame> frames = scene::frames_as_set_up(scene->bones[0].bones);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        CHECK(scene::distance(frames[i].origin, spots[i]) < 1.0 / 16);
        CHECK(scene::distance(frames[i].tip(), spots[i + 1]) < 1.0 / 8);
    }
}

TEST_CASE("bones are named and placed")
{
    CHECK(bones_read("bone a 0 0 10") == "1:1 error: bone needs more values (write bone NAME X Y X Y)");
    CHECK(bones_read("bone a 0 0 10 0 5") ==
          "1:17 error: this value is too many for bone (write bone NAME X Y X Y)");
    CHECK(bones_read("bone a 0 0 10 0 width=2").starts_with("1:17 error: bone has no property \"width\""));
    CHECK(bones_read("bone a 0 0 10 0 { bones b }") ==
          "1:19 error: a bone has no node \"bones\" (did you mean \"bone\"?)");
    CHECK(bones_read("bone a 0 0 10 0\nbone a 0 0 0 10") ==
          "2:1 error: there is a bone \"a\" already, on line 4");
    CHECK(bones_read("bone \"\" 0 0 10 0") == "1:6 error: a name cannot be empty");
    CHECK(
        bones_read("bone points 0 0 10 0")
            .starts_with("1:6 error: a bone cannot be called \"points\" (choose another name: weights have a "
                         "node of this one)"));
    CHECK(bones_read("bone a 0 0 10 0 region=-1") ==
          "1:24 error: this number is out of range (allowed: 0 to 4094)");
    CHECK(bones_read("bon a 0 0 10 0")
              .starts_with("0:1 error: this skeleton has no bones (add { bone NAME X Y X Y })\n"
                           "1:1 error: a skeleton has no node \"bon\" (did you mean \"bone\"?)"));
}

TEST_CASE("a bone has a length, and lies near its parent")
{
    CHECK(bones_read("bone a 5 5 5 5\nbone b 5 5 5.02 5.02") ==
          "1:1 error: this bone has no length (let it end elsewhere than it begins)\n"
          "2:1 error: this bone has no length (let it end elsewhere than it begins)");
    CHECK(bones_read("bone a 0 0 0.05 0") == "a 0 0 0 1");
    CHECK(bones_read("bone a -2000 -2000 2000 2000") == "1:1 error: this bone is longer than 4095 px");
    CHECK(
        bones_read("bone a -2000 0 -1900 0 { bone b 100 0 110 0 }") ==
        "1:26 error: this bone begins more than 2047 px from its parent's origin (put a bone between them)");
}

TEST_CASE("bones hang on others, and in the end on a root")
{
    CHECK(bones_read("bone torso 0 0 10 0\nbone arm 0 0 10 0 parent=torsoo") ==
          "2:26 error: unknown bone \"torsoo\" (did you mean \"torso\"?)");
    CHECK(
        bones_read("bone a 0 0 10 0 parent=a") ==
        "1:17 error: the bone \"a\" hangs on itself, and on no root (a → a; let one of them have no parent)");
    CHECK(bones_read("bone root 0 0 10 0\nbone c 0 0 10 0 parent=b\nbone a 0 0 10 0 parent=b\n"
                     "bone b 0 0 10 0 parent=a") ==
          "3:17 error: the bone \"a\" hangs on itself, and on no root (a → b → a; let one of them have no "
          "parent)");
    CHECK(bones_read("bone a 0 0 10 0 { bone b 0 0 10 0 parent=a }") ==
          "1:35 error: this bone stands inside of its parent already (remove parent=…, or write the bone "
          "outside of the other)");
}

TEST_CASE("skeletons without a root are reported each")
{
    CHECK(
        read_on_canvas("bones s { bone a 0 0 1 0 parent=b; bone b 0 0 1 0 parent=a }\n"
                       "bones t { bone c 0 0 1 0 parent=c }\nobject o fill=red skin=s { empty }\n"
                       "object p fill=red skin=t { empty }")
            .findings ==
        "3:26 error: the bone \"a\" hangs on itself, and on no root (a → b → a; let one of them have no "
        "parent)\n"
        "4:26 error: the bone \"c\" hangs on itself, and on no root (c → c; let one of them have no parent)");
}

TEST_CASE("a skeleton has a name of its own, and something to carry")
{
    const std::string skeleton = "bones s { bone a 0 0 10 0 }\n";
    CHECK(read_on_canvas(skeleton + skeleton + "object o fill=red skin=s { empty }").findings ==
          "4:1 error: there is a skeleton \"s\" already, on line 3");
    CHECK(read_on_canvas(skeleton).findings ==
          "3:1 warning: the skeleton \"s\" carries nothing (add skin=s to an object, or remove it)");
    CHECK(read_on_canvas("bones { bone a 0 0 10 0 }").findings ==
          "3:1 error: bones needs more values (write bones NAME { bone NAME X Y X Y })");
    CHECK(bones_read("bone a 0 0 10 0", "turns=longest") ==
          "0:15 error: unknown value \"longest\" (allowed: shortest, as-written)");
}

TEST_CASE("a skeleton has at most 255 bones, and all together 1024")
{
    CHECK(bones_read(chain_of(255)).find("error") == std::string::npos);
    CHECK(bones_read(chain_of(257)) == "256:1 error: a skeleton has at most 255 bones");
    std::string scene;
    for (const char* const name : {"a", "b", "c", "d"})
        scene += std::string{"bones "} + name + " { " + chain_of(255) + " }\n";
    CHECK(read_on_canvas(scene + "bones e { " + chain_of(4) + "}").findings.find("error") ==
          std::string::npos);
    CHECK(read_on_canvas(scene + "bones e { " + chain_of(5) + "}")
              .findings.find("error: the skeletons of a scene have at most 1024 bones together") !=
          std::string::npos);
}
}
