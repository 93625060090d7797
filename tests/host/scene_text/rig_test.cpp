#include "tests/host/scene_text/art_parts.hpp"
#include "tests/host/scene_text/written.hpp"

namespace kfast::test {
namespace {

using art::Ease;
using art::EaseKind;

art::Document with_arm(art::Channel upper_turn, art::Channel lower_turn)
{
    art::Bone upper;
    upper.name = "upper";
    upper.from = {10, 10};
    upper.to = {30, 10};
    upper.rotation = std::move(upper_turn);
    art::Bone lower;
    lower.name = "lower";
    lower.parent = 0;
    lower.from = {30, 10};
    lower.to = {50, 10};
    lower.rotation = std::move(lower_turn);
    lower.at_tip = true;
    art::Shape sleeve;
    sleeve.drawing = {
        art::Drawing{{{{10, 10}, {scene::line_to({30, 10}), scene::line_to({50, 10})}, false}}}};
    sleeve.stroke = art::StrokeStyle{};
    sleeve.skin = art::Skin{0, {{{0, 1}}, {{0, 1}, {1, 1}}, {{1, 2}}}, false};
    art::Document made = document({node("sleeve", std::move(sleeve))});
    made.rigs = {{"arm", {upper, lower}}};
    return made;
}

}

TEST_CASE("bones, poses and weights are written")
{
    const std::string text = written(with_arm(rising(0, 90), {0}));
    CHECK(text.find(R"(bones arm {
    bone upper 10 10 30 10 { bone lower 30 10 50 10 }
    pose 0 { upper }
    pose 30 { upper turn=90 }
}

object sleeve stroke=black skin=arm {
    line 10 10 30 10 50 10
    weights {
        points 1 { upper 1 }
        points 2 { upper 0.5; lower 0.5 }
        points 3 { lower 1 }
    }
}
)") != std::string::npos);
}

TEST_CASE("bones that leave a moment by different laws have poses of their own")
{
    const std::string text =
        written(with_arm(art::Channel{{{0, 0, {EaseKind::hold}}, {30, 90, {}}}}, rising(0, 45)));
    CHECK(text.find("pose 0 law=hold { upper }\n    pose 0.001 { lower }\n") != std::string::npos);
}

TEST_CASE("a length is told only where it is another than that of the bone as it is set up")
{
    art::Document made = with_arm(rising(0, 90), {0});
    made.rigs.front().bones.front().length = {20.06};
    CHECK(written(made) == written(with_arm(rising(0, 90), {0})));
    made.rigs.front().bones.front().length = {21};
    CHECK(written(made).find("pose 0 { upper length=21 }") != std::string::npos);
    made.rigs.front().bones.front().length = rising(20, 30);
    CHECK(written(made).find("pose 0 { upper length=20 }") != std::string::npos);
}

TEST_CASE("bones that turn further than half a turn do so as written")
{
    CHECK(written(with_arm(rising(0, 720), {0})).find("bones arm turns=as-written {") != std::string::npos);
    CHECK(written(with_arm(rising(0, 180), {0})).find("bones arm turns=as-written {") != std::string::npos);
}

TEST_CASE("a key of one quantity divides the way of another")
{
    art::Document made =
        with_arm(art::Channel{{{0, 0, {EaseKind::cubic, 0.42, 0, 0.58, 1}}, {30, 90, {}}}}, {0});
    made.rigs.front().bones.front().x = art::Channel{{{0, 0, {}}, {15, 8, {}}}};
    const std::string text = written(made);
    CHECK(text.find("pose 15 law=\"bezier(") != std::string::npos);
    CHECK(text.find("{ upper turn=45 x=8 }") != std::string::npos);
}

TEST_CASE("a figure that follows one bone says so")
{
    art::Document made = with_arm({0}, rising(0, 45));
    std::get<art::Shape>(made.nodes.front().content).skin->points = {{{1, 1}}, {{1, 1}}, {{1, 5}}};
    CHECK(written(made).find("object sleeve stroke=black skin=arm bone=lower { line 10 10 30 10 50 10 }") !=
          std::string::npos);
}

TEST_CASE("a skeleton that carries nothing is left out")
{
    art::Document made = with_arm({0}, {0});
    std::get<art::Shape>(made.nodes.front().content).skin.reset();
    CHECK(written(made).find("bones") == std::string::npos);
}

TEST_CASE("what bones do beyond the numbers of scenes is told")
{
    const auto loss_of = [](const art::Document& made) {
        art::Losses losses;
        written(made, losses);
        REQUIRE(losses.list().size() == 1);
        CHECK(losses.list()[0].layer == "arm");
        return losses.list()[0].feature;
    };
    CHECK(loss_of(with_arm(rising(0, 5401), {0})) == "a bone that turns more than 15 times");
    art::Document far = with_arm({0}, {0});
    far.rigs.front().bones.front().x = rising(0, 2100);
    CHECK(loss_of(far) == "coordinates of bones beyond 2047 px");
    far.rigs.front().bones.front().x = rising(0, 2040);
    CHECK(loss_of(far) == "a bone that begins more than 2047 px from its parent's origin");
    art::Document long_bone = with_arm({0}, {0});
    long_bone.rigs.front().bones.back().length = rising(20, 4100);
    CHECK(loss_of(long_bone) == "a bone longer than 4095 px");
}

TEST_CASE("bones count for how far coordinates go")
{
    art::Losses losses;
    art::Document far = with_arm({0}, {0});
    far.rigs.front().bones.front().y = rising(0, -2500);
    const scene_text::Reach reach = scene_text::scene_text(far, "x", 0.1, losses).reach;
    CHECK(reach.left_alone == 2500);
    CHECK(reach.in_groups == 2500);
}

}
