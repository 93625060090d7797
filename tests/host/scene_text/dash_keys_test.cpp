#include "tests/host/scene_text/art_parts.hpp"
#include "tests/host/scene_text/written.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace kfast::test {

using art::Ease;
using art::EaseKind;
using art::Group;
using art::Node;
using art::Transform;

namespace {

Node dashed_box(std::vector<art::Channel> lengths)
{
    Node box = red_box("box");
    auto& shape = std::get<art::Shape>(box.content);
    shape.fill.reset();
    shape.stroke = art::StrokeStyle{};
    shape.stroke->dashes.lengths = std::move(lengths);
    return box;
}

art::StrokeStyle& stroke_of(Node& node) { return *std::get<art::Shape>(node.content).stroke; }

}

TEST_CASE("dashes have keys of their own beside earlier ones, and among those of a colour")
{
    Node box = dashed_box({art::Channel{{{20, 4, {}}, {50, 30, {}}}}, {10}});
    stroke_of(box).colour = art::Animated<art::Rgb>{
        {{0, {1, 0, 0}, {}}, {20, {0, 0, 1}, {.kind = EaseKind::hold}}, {40, {0, 1, 0}, {}}}};
    CHECK(written_items({box}) == R"(object box stroke=box dash="4 10" {
    rect 10 10 20 20
    key 0 stroke=box
    key 19.999 dash="4 10"
    key 20 law=hold stroke=box-2
    key 40 stroke=box-3
    key 50 dash="30 10"
}
)");
    stroke_of(box).dashes.lengths.front().keys.front().time = 0;
    stroke_of(box).colour.keys.front().ease.kind = EaseKind::hold;
    CHECK(written_items({box}).find(R"(
    key 0 law=hold stroke=box
    key 0.001 dash="4 10"
    key 20 )") != std::string::npos);
}

TEST_CASE("lengths of dashes that go by different eases are sampled, others keep theirs")
{
    const Ease ease{EaseKind::cubic, 0.4, 0, 0.6, 1};
    const art::Channel eased{{{0, 4, ease}, {40, 24, {}}}};
    const art::Channel alike{{{0, 8, ease}, {40, 2, {}}}};
    const art::Channel held{{{0, 8, {.kind = EaseKind::hold}}, {40, 2, {}}}};
    const std::string same = written_items({dashed_box({eased, alike})});
    CHECK(same.find("key 0 law=\"bezier(0.4,0,0.6,1)\" dash=\"4 8\"\n    key 40 dash=\"24 2\"") !=
          std::string::npos);
    const std::string sampled = written_items({dashed_box({eased, held})});
    CHECK(std::ranges::count(sampled, '\n') > 20);
    CHECK(sampled.find("key 39.999 law=hold dash=\"24 8\"\n    key 40 dash=\"24 2\"") != std::string::npos);
}

TEST_CASE("dashes are a whole line while they are too many, and always if they are never long enough")
{
    const art::Channel shrinking{{{0, 20, {}}, {60, 0, {}}}};
    const art::Channel growing{{{0, 0, {}}, {60, 20, {}}}};
    CHECK(written_items({dashed_box({growing, shrinking})}).find("key 0 dash=\"0 20\"") != std::string::npos);
    const art::Channel held{{{0, 0.1, {.kind = EaseKind::hold}}, {30, 20, {}}}};
    const art::Channel growing_late{{{0, 0, {.kind = EaseKind::hold}}, {30, 10, {}}, {60, 20, {}}}};
    Node large = dashed_box({held, growing_late});
    std::get<art::Shape>(large.content).drawing = {box(10, 10, 900, 800)};
    CHECK(written_items({large}).find("key 0 law=hold dash=\"0 0\"") != std::string::npos);
    art::Document fine = document({dashed_box({{0.1}, art::Channel{{{0, 0, {}}, {60, 0.1, {}}}}})});
    CHECK(loss_of(fine) == "dashes and gaps shorter than 1/4 px together");
}

TEST_CASE("an offset of dashes that is out of range loses whole periods")
{
    Node box = dashed_box({{8}, {12}});
    stroke_of(box).dashes.offset = rising(5, -19995);
    CHECK(written_items({box}).find(
              "at 0 5005; at 14.999 -4995 law=hold; at 15 5005; at 29.999 -4995 law=hold") !=
          std::string::npos);
    stroke_of(box).dashes.offset = {2e4 + 3};
    CHECK(written_items({box}).find(" dash-offset=3 ") != std::string::npos);
    stroke_of(box).dashes.offset = rising(0, 1e8);
    CHECK(loss_of(document({box})) == "an offset of dashes beyond 16384 px");
}

TEST_CASE("what is dashed or trimmed is measured before it is squashed")
{
    Transform squashed;
    squashed.scale_x = {1.03}; // so little that nobody is told of the width of the line
    Node dashed = dashed_box({{4}, {6}});
    stroke_of(dashed).width = {2};
    CHECK(written_items({node("", Group{{dashed}}, squashed)}) ==
          "object box stroke=black dash=\"4 6\" width=2 pivot-x=0 pivot-y=0 scale-x=1.03 { rect 10 10 20 20 "
          "}\n");
    stroke_of(dashed).dashes = {};
    std::get<art::Shape>(dashed.content).trim.emplace().end = rising(0, 1);
    CHECK(written_items({node("", Group{{dashed}}, squashed)}).find(" scale-x=1.03") != std::string::npos);
}

}
