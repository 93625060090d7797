#include "host/scene/skeleton/bone_frames.hpp"
#include "host/scene/skeleton/reach_reader.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

namespace kfast::test {
namespace {

/// The arm is bent to the right as set up: its joint lies below the line to its tip.
const std::string arm = "bone body 20 90 20 50 { bone upper 20 50 50 60 { bone lower 50 60 90 50 } }\n";

scene::Scene reaching(const std::string& movement, std::string& findings)
{
    const auto text =
        read_on_canvas("bones s {\n" + arm + movement + "\n}\nobject o fill=red skin=s { empty }");
    findings = text.findings;
    REQUIRE(text.scene);
    return *text.scene;
}

std::string findings_of(const std::string& movement)
{
    return bones_read("bone body 20 90 20 50 { bone upper 20 50 50 60 { bone lower 50 60 90 50 } }\n" +
                      movement);
}

struct Target {
    Time time;
    scene::Vec2 spot;
};

/// The largest distance of the tip from where it is to be, at random times; straight ways at even speed.
double worst_miss(const scene::Scene& scene, const std::vector<Target>& targets, std::mt19937& random)
{
    double worst = 0;
    for (std::size_t i = 0; i + 1 < targets.size(); ++i)
        for (int sample = 0; sample < 400; ++sample) {
            const std::int32_t ticks = targets[i + 1].time.ticks - targets[i].time.ticks;
            const auto passed = static_cast<std::int32_t>(random() % static_cast<unsigned>(ticks + 1));
            const double share = 1.0 * passed / ticks;
            const scene::Vec2 spot = (1 - share) * targets[i].spot + share * targets[i + 1].spot;
            const auto frames = scene::frames_at(scene.bones[0].bones, targets[i].time + Time{passed});
            worst = std::max(worst, scene::distance(frames[2].tip(), spot));
        }
    return worst;
}

double side_of_joint(const scene::Scene& scene, Time time)
{
    const auto frames = scene::frames_at(scene.bones[0].bones, time);
    return scene::cross(frames[2].tip() - frames[1].origin, frames[2].origin - frames[1].origin);
}

std::string at_node(int frame, scene::Vec2 spot)
{
    return "at " + std::to_string(frame) + ' ' + std::to_string(spot.x) + ' ' + std::to_string(spot.y) + "; ";
}

}

TEST_CASE("the tip follows its target within 1/16 px, whatever moves the bones above")
{
    std::mt19937 random{77};
    const auto within = [&random](double low, double high) {
        return std::uniform_real_distribution<double>{low, high}(random);
    };
    for (int round = 0; round < 60; ++round) {
        std::vector<Target> targets;
        std::string ats;
        for (int i = 0, frame = 0; i < 4; ++i, frame += 1 + static_cast<int>(random() % 20)) {
            targets.push_back({Time::frame(frame), {within(40, 75), within(30, 70)}});
            ats += at_node(frame, targets.back().spot);
        }
        const bool is_left = round % 2 == 0;
        std::string findings;
        const scene::Scene scene =
            reaching("pose 0 law=accelerate-decelerate { body turn=-3; upper length=30 }\n"
                     "pose 9 law=decelerate { body turn=5 y=-2; upper length=34; lower }\npose 30 rest\n"
                     "reach lower bend=" +
                         std::string{is_left ? "left" : "right"} + " { " + ats + "}",
                     findings);
        REQUIRE(findings == "");
        CHECK(worst_miss(scene, targets, random) <= 1.0 / 16);
        for (const Target& target : targets)
            CHECK((side_of_joint(scene, target.time) < 0) == is_left);
    }
}

TEST_CASE("as many keys as it takes, at whole frames where that is enough")
{
    std::string findings;
    const scene::Scene still = reaching("reach lower { at 0 60 40; at 30 60 40 }", findings);
    CHECK(still.bones[0].bones[1].keys[0].size() == 2);
    CHECK(still.length == Time::frame(30));
    const scene::Scene moving = reaching("reach lower { at 0 60 40; at 30 75 65 }", findings);
    const auto& keys = moving.bones[0].bones[1].keys[0];
    CHECK(keys.size() > 3);
    CHECK(keys.size() < 12);
    CHECK(std::ranges::all_of(keys, [](const scene::TrackKey& key) { return key.time.ticks % 1024 == 0; }));
}

TEST_CASE("the target goes by its law, and may jump")
{
    std::string findings;
    const scene::Scene scene =
        reaching("reach lower { at 20 60 40 law=hold; at 30 75 65; at 0 75 65 law=accelerate }", findings);
    const auto tip = [&scene](double frame) {
        const Time time{static_cast<std::int32_t>(frame * 1024)};
        return scene::frames_at(scene.bones[0].bones, time)[2].tip();
    };
    CHECK(findings == "");
    CHECK(scene::distance(tip(29.99), {60, 40}) <= 1.0 / 16);
    CHECK(scene::distance(tip(30), {75, 65}) <= 1.0 / 16);
    const double accelerated = 1 - std::cos(0.25 * std::acos(-1));
    CHECK(scene::distance(tip(10), {75 - 15 * accelerated, 65 - 25 * accelerated}) <= 1.0 / 16);
}

TEST_CASE("the arm bends as it is set up unless it is told; a straight one has to be told")
{
    std::string findings;
    CHECK(side_of_joint(reaching("reach lower { at 5 60 40 }", findings), Time::frame(5)) > 0);
    const std::string straight = "bone a 0 0 20 0 { bone b 20 0 40 0 }\nreach b";
    CHECK(bones_read(straight + " { at 0 30 5 }") ==
          "2:1 error: the bones are set up in a straight line, which tells no side to bend to (add bend=left "
          "or bend=right)");
    CHECK(bones_read(straight + " bend=left { at 0 30 5 }").find("error") == std::string::npos);
}

TEST_CASE("an arm is stretched towards what it does not reach, with a warning")
{
    const auto text = read_on_canvas("bones s { bone a 0 0 20 0 { bone b 20 0 30 0 }\n"
                                     "reach b bend=left {\nat 0 20 5\nat 10 40 0\nat 20 3 0\n}\n}\n"
                                     "object o fill=red skin=s { empty }");
    CHECK(text.findings == "6:1 warning: the tip of \"b\" does not reach its target: at frame 10, 10 px are "
                           "missing (it goes as near as the bones let it; make them longer, or choose other "
                           "targets)");
    REQUIRE(text.scene);
    const auto tip = [&](int frame) {
        return scene::frames_at(text.scene->bones[0].bones, Time::frame(frame))[1].tip();
    };
    CHECK(scene::distance(tip(10), {30, 0}) <= 1.0 / 16);
    CHECK(scene::distance(tip(20), {10, 0}) <= 1.0 / 16);
}

TEST_CASE("poses turn the bones before and behind a reach, but not within")
{
    std::string findings;
    const scene::Scene scene =
        reaching("pose 0 law=accelerate { upper turn=90 }; pose 10 rest; pose 30 { upper turn=45 }\n"
                 "reach lower { at 10 60 40; at 20 60 40 }",
                 findings);
    CHECK(findings == "");
    const auto& keys = scene.bones[0].bones[1].keys[0];
    REQUIRE(keys.size() == 4);
    CHECK(keys[0].time == Time{});
    CHECK(keys[0].laws == LawPair{VelocityLaw::accelerate, VelocityLaw::accelerate});
    CHECK(keys[1].time == Time::frame(10));
    CHECK(keys[2].time == Time::frame(20));
    CHECK(keys[2].laws == LawPair{});
    CHECK(keys[3].time == Time::frame(30));
    CHECK(findings_of("pose 15 { upper turn=3 }\nreach lower { at 10 60 40; at 20 60 40 }") ==
          "2:11 error: \"upper\" is turned by the reach on line 6 at this time (leave out turn=…, or let the "
          "reach begin later or end earlier)");
}

TEST_CASE("two reaches do not turn one bone at a time")
{
    const std::string first = "reach lower { at 10 60 40; at 20 60 40 }\n";
    CHECK(findings_of(first + "reach upper { at 20 30 60; at 30 30 60 }") ==
          "3:1 error: the reach on line 5 turns one of these bones at the same time (let one of them end "
          "before the other begins)");
    CHECK(findings_of(first + "reach upper { at 21 30 60; at 30 30 60 }").find("error") == std::string::npos);
}

TEST_CASE("as written, a reach turns the short way from where the bone is")
{
    std::string findings;
    const auto text = read_on_canvas("bones s turns=as-written {\n" + arm +
                                     "pose 0 { upper turn=720 }; reach lower { at 9 60 40; at 20 75 65 }\n}\n"
                                     "object o fill=red skin=s { empty }");
    REQUIRE(text.scene);
    const auto& keys = text.scene->bones[0].bones[1].keys[0];
    for (std::size_t i = 1; i < keys.size(); ++i)
        CHECK(std::abs(keys[i].value - keys[i - 1].value) <= 32768);
    CHECK(keys.front().value > 2 * 65536);
}

TEST_CASE("what a reach needs")
{
    CHECK(findings_of("reach lowr { at 0 60 40 }") ==
          "2:7 error: unknown bone \"lowr\" (did you mean \"lower\"?)");
    CHECK(
        findings_of("reach body { at 0 60 40 }") ==
        "2:7 error: to reach takes two bones, and \"body\" has no parent (name the last bone of an arm or a "
        "leg)");
    CHECK(bones_read("bone a 0 0 20 0 { bone b 20 0 20 9 tip=#false }\nreach b { at 0 5 5 }") ==
          "2:7 error: \"b\" does not begin at the tip of \"a\" (let it begin exactly where \"a\" ends)");
    CHECK(findings_of("reach lower") == "2:1 error: this reach has no target (add { at TIME X Y })");
    CHECK(findings_of("reach lower { at 0 60 }") ==
          "2:15 error: at needs more values (write at TIME X Y law=LAW)");
    CHECK(findings_of("reach lower { to 0 60 40 }") ==
          "2:15 error: a reach has no node \"to\" (allowed: at)");
    CHECK(findings_of("reach lower bend=up { at 0 60 40 }") ==
          "2:18 error: unknown value \"up\" (allowed: left, right)");
    CHECK(findings_of("reach lower { at 5 60 40; at 5 60 41 }") ==
          "2:27 error: there is a target at this time already, on line 5 (times are rounded to 1/1024 frame; "
          "choose another)");
    CHECK(findings_of("reach lower { at 5 60 40 law=hold; at 1 60 41 }")
              .ends_with("2:26 warning: this law governs nothing (remove it, or add a later target)"));
}
}
