#include "host/program/failure.hpp"
#include "tests/host/scene_text/art_parts.hpp"
#include "tests/host/scene_text/written.hpp"

#include <cmath>
#include <limits>

namespace kfast::test {
namespace {

using art::Ease;
using art::EaseKind;
using art::Group;
using art::Node;
using art::Transform;

}

TEST_CASE("a document becomes a scene with a canvas and a palette")
{
    art::Document made = document({red_box("box")});
    made.background = art::Rgb{0, 0, 0.2};
    made.frame_rate = 23.976;
    made.loop = Loop::ping_pong;
    CHECK(written(made) == R"(// Made from test.json.

kfast 1
canvas 100 80 fps=23.976 frames=60 loop=ping-pong background=background

palette { background "#000033"; box "#ff0000" }

object box fill=box { rect 10 10 20 20 }
)");
}

TEST_CASE("an empty document is an empty scene")
{
    CHECK(written(document({})) == "// Made from test.json.\n\nkfast 1\ncanvas 100 80 frames=60\n");
}

TEST_CASE("the origin is told without its folder")
{
    art::Losses losses;
    CHECK(scene_text::scene_text(document({}), "some/where/eye.json", 0.1, losses)
              .text.starts_with("// Made from eye.json.\n"));
}

TEST_CASE("what stands still is drawn where it is seen")
{
    Transform moved;
    moved.x = {5};
    moved.rotate = {90};
    moved.scale_x = moved.scale_y = {2};
    Node stroke = red_box("box");
    auto& shape = std::get<art::Shape>(stroke.content);
    shape.fill.reset();
    shape.stroke = art::StrokeStyle{};
    CHECK(written_items({node("", Group{{stroke}}, moved)}) ==
          "object box stroke=black width=2 { polygon -15 20 -15 60 -55 60 -55 20 }\n");
}

TEST_CASE("what turns turns about where it is seen")
{
    Transform turning;
    turning.anchor_x = {20};
    turning.anchor_y = {20};
    turning.x = {50};
    turning.y = {40};
    turning.rotate = rising(0, 90);
    CHECK(written_items({node("box", filled(box(10, 10, 20, 10)), turning)}) ==
          R"(object box fill=box pivot-y=40 {
    rect 40 30 20 10
    track rotate law=constant { at 0 0; at 30 90 }
}
)");
}

TEST_CASE("a group with one node becomes that node, and keeps its own name")
{
    Transform moving;
    moving.x = rising(0, 40);
    Transform turning;
    turning.anchor_x = {20};
    turning.anchor_y = turning.y = {20};
    turning.x = {20};
    turning.rotate = rising(0, 90);
    CHECK(written_items(
              {node("layer", Group{{node("inner", filled(box(10, 10, 20, 20)), turning)}}, moving)}) ==
          R"(object layer fill=layer {
    rect 10 10 20 20
    track x law=constant { at 0 0; at 30 40 }
    track rotate law=constant { at 0 0; at 30 90 }
}
)");
}

TEST_CASE("parts of one group that lie beside each other become one")
{
    Transform turning;
    turning.rotate = rising(0, 90);
    Node first = node("arm", Group{{red_box("a")}}, turning);
    Node second = node("arm", Group{{red_box("b")}}, turning);
    first.parent_tag = second.parent_tag = 7;
    CHECK(written_items({first, second}) == R"(group arm {
    track rotate law=constant { at 0 0; at 30 90 }
    object a fill=a { rect 10 10 20 20 }
    object b fill=a { rect 10 10 20 20 }
}
)");
}

TEST_CASE("what hangs alone on a parent keeps its own name")
{
    Transform turning;
    turning.rotate = rising(0, 90);
    Node parent = node("parent", Group{{red_box("box")}}, turning);
    parent.parent_tag = 3;
    CHECK(written_items({parent}).starts_with("object box fill=box "));
}

TEST_CASE("the law that most ways have is that of the track")
{
    Transform moving;
    const Ease ease{EaseKind::cubic, 0.42, 0, 0.58, 1};
    moving.x = art::Channel{{{0, 0, ease}, {10, 5, ease}, {20, 0, {EaseKind::hold}}, {30, 9, {}}}};
    CHECK(written_items({node("box", filled(box(10, 10, 20, 20)), moving)})
              .find("track x law=ease-in-out { at 0 0; at 10 5; at 20 0 law=hold; at 30 9 }") !=
          std::string::npos);
}

TEST_CASE("an ease that swings further than laws do is divided")
{
    Transform moving;
    moving.x = art::Channel{{{0, 0, {EaseKind::cubic, 0.3, -4, 0.7, 5}}, {32, 16, {}}}};
    const std::string items = written_items({node("box", filled(box(10, 10, 20, 20)), moving)});
    INFO(items);
    CHECK(items.find("at 16 8") != std::string::npos);
    CHECK(items.find("at 32 16") != std::string::npos);
}

TEST_CASE("keys that change nothing are left out")
{
    Transform moving;
    moving.x = art::Channel{{{0, 5, {}}, {10, 5, {}}, {20, 5, {}}, {30, 9, {}}, {40, 9, {}}}};
    CHECK(written_items({node("box", filled(box(10, 10, 20, 20)), moving)})
              .find("track x law=constant { at 20 5; at 30 9 }") != std::string::npos);
}

TEST_CASE("drawings and colours share keys, each with its law")
{
    const Ease ease{EaseKind::cubic, 0, 0, 0.58, 1};
    Node both =
        node("box",
             filled(art::Animated<art::Drawing>{{{0, box(0, 0, 10, 10), ease}, {20, box(0, 0, 20, 10), {}}}},
                    art::Animated<art::Rgb>{{{0, {1, 1, 1}, {}}, {20, {0, 0, 0}, {}}}}));
    CHECK(written_items({both}) == R"(object box fill=white {
    key 0 law-x=ease-out law-y=ease-out fill=white { rect 0 0 10 10 }
    key 20 fill=black { rect 0 0 20 10 }
}
)");
}

TEST_CASE("a fill and a line with different laws become two objects")
{
    Node both =
        node("box", filled(box(0, 0, 10, 10), art::Animated<art::Rgb>{{{0, {1, 1, 1}, {}}, {20, {}, {}}}}));
    auto& shape = std::get<art::Shape>(both.content);
    shape.stroke = art::StrokeStyle{};
    shape.stroke->colour = art::Animated<art::Rgb>{{{0, {}, {EaseKind::hold}}, {20, {1, 1, 1}, {}}}};
    const std::string items = written_items({both});
    CHECK(items.find("object box fill=white {") != std::string::npos);
    CHECK(items.find("object box-line stroke=black {") != std::string::npos);
}

TEST_CASE("the opacity of a fill goes into its colour, or if it changes becomes that of the object")
{
    Node still = red_box("still");
    std::get<art::Shape>(still.content).fill->opacity = {0.5};
    Node fading = red_box("fading");
    std::get<art::Shape>(fading.content).fill->opacity = rising(0, 1);
    const std::string text = written(document({still, fading}));
    CHECK(text.find("still \"#ff000080\"") != std::string::npos);
    CHECK(text.find("track opacity law=constant { at 0 0; at 30 1 }") != std::string::npos);
}

TEST_CASE("spans are keys of visibility")
{
    Node shown = red_box("box");
    shown.shown = {{-5, 10}, {20, 70}};
    CHECK(written_items({shown}) == R"(object box fill=box {
    rect 10 10 20 20
    key 0 visible=#true
    key 10 visible=#false
    key 20 visible=#true
}
)");
}

TEST_CASE("what is never seen is left out")
{
    Node hidden = red_box("hidden");
    hidden.shown = {};
    Node late = red_box("late");
    late.shown = {{60, 100}};
    Node clear = red_box("clear");
    clear.opacity = {0};
    Node thin = red_box("thin");
    std::get<art::Shape>(thin.content).fill.reset();
    std::get<art::Shape>(thin.content).stroke = art::StrokeStyle{};
    std::get<art::Shape>(thin.content).stroke->width = {0};
    CHECK(written_items({hidden, late, clear, thin, node("none", Group{}), node("none", art::Shape{})}) ==
          "");
}

TEST_CASE("a path to move along is kept")
{
    Transform along;
    along.anchor_x = along.anchor_y = {20};
    along.path = art::MotionPath{
        {{{{20, 20}, {scene::cubic_to({40, 0}, {60, 40}, {80, 20})}, false}}}, rising(0, 1), true};
    CHECK(written_items({node("bee", filled(box(10, 10, 20, 20)), along)}).find(R"(track along "M 0 0 C)") ==
          std::string::npos);
    const std::string items = written_items({node("bee", filled(box(10, 10, 20, 20)), along)});
    CHECK(items.find(
              "track along \"M 20 20 C 40 0 60 40 80 20\" turn=#true law=constant { at 0 0; at 30 1 }") !=
          std::string::npos);
}

TEST_CASE("markers are events, and those that last are clips as well")
{
    art::Document made = document({red_box("box")});
    made.markers = {{"end", 60, 0}, {"walk", 10, 20}, {"walk", 30, 100}, {"go", 5, 0}};
    CHECK(items_of(written(made)) == R"(object box fill=box { rect 10 10 20 20 }

clip walk from=10 to=30
clip walk-2 from=30 to=60
event 5 go
event 10 walk
event 30 walk
event 0 end
)");
    made.markers = {{"late", 70, 0}};
    CHECK(loss_of(made) != "");
}

TEST_CASE("what leans all the time is drawn so, and what leans more and more is baked")
{
    Transform leaning;
    leaning.skew = {45};
    CHECK(written_items({node("box", filled(box(0, 0, 10, 10)), leaning)}) ==
          "object box fill=box { polygon 0 0 10 0 0 10 -10 10 }\n");
    leaning.skew = rising(0, 45);
    const std::string items = written_items({node("box", filled(box(0, 0, 10, 10)), leaning)});
    INFO(items);
    CHECK(items.find("key 30 { polygon 0 0 10 0 0 10 -10 10") != std::string::npos);
}

TEST_CASE("a line whose pen would be bent is a loss")
{
    Transform wide;
    wide.scale_x = {2};
    Node stroke = node("box", filled(box(0, 0, 10, 10)), wide);
    CHECK(loss_of(document({stroke})) == "");
    std::get<art::Shape>(stroke.content).stroke = art::StrokeStyle{};
    CHECK(loss_of(document({stroke})) == "a line that becomes wider one way than the other");
}

TEST_CASE("what is drawn too large for coordinates is drawn smaller and grows")
{
    CHECK(written_items({node("box", filled(box(-4000, 0, 8000, 10)))}) ==
          "object box fill=box pivot-y=0 scale=2 { rect -2000 0 4000 5 }\n");
}

TEST_CASE("what turns in space has a camera, that of the document or a far one")
{
    Transform turning;
    turning.rotate_y = rising(0, 90);
    art::Document made = document({node("card", filled(box(10, 10, 20, 20)), turning)});
    CHECK(written(made).find("camera=32767") != std::string::npos);
    made.camera = 400;
    CHECK(written(made).find("camera=400") != std::string::npos);
}

TEST_CASE("more colours than a palette holds become the nearest of them")
{
    std::vector<Node> nodes;
    nodes.reserve(300);
    for (int i = 0; i < 300; ++i)
        nodes.push_back(node("box", filled(box(0, 0, 10, 10), art::Rgb{i / 299.0, 0.5, i % 2 / 2.0})));
    CHECK(loss_of(document(std::move(nodes))) == "more than 255 colours");
}

TEST_CASE("numbers that are none are refused")
{
    for (const double number : {std::numeric_limits<double>::infinity(), std::nan("")}) {
        Transform transform;
        transform.x = {number};
        art::Losses losses;
        CHECK_THROWS_AS(scene_text::scene_text(document({node("box", filled(box(0, 0, 1, 1)), transform)}),
                                               "x", 0.1, losses),
                        Failure);
        CHECK_THROWS_AS(
            scene_text::scene_text(document({node("box", filled(box(number, 0, 1, 1)))}), "x", 0.1, losses),
            Failure);
    }
}

TEST_CASE("a canvas or a scene that is too large is refused")
{
    art::Losses losses;
    art::Document wide = document({});
    wide.width = 2048;
    CHECK_THROWS_AS(scene_text::scene_text(wide, "x", 0.1, losses), Failure);
    art::Document endless = document({});
    endless.frames = 1e7;
    CHECK_THROWS_AS(scene_text::scene_text(endless, "x", 0.1, losses), Failure);
}

TEST_CASE("what goes far is told, with and without groups that grow")
{
    Transform moving;
    moving.x = rising(0, 3000);
    art::Losses losses;
    const scene_text::Reach reach =
        scene_text::scene_text(document({node("box", filled(box(0, 0, 8, 8)), moving)}), "x", 0.1, losses)
            .reach;
    CHECK(reach.left_alone == 3000);
    CHECK(reach.in_groups == 1500);
    Transform turning;
    turning.x = turning.anchor_x = {1500};
    turning.rotate = rising(0, 90);
    CHECK(scene_text::scene_text(document({node("box", filled(box(0, 0, 8, 8)), turning)}), "x", 0.1, losses)
              .reach.left_alone == 1500);
    CHECK(losses.empty());
}

TEST_CASE("huge numbers are held, and that is told")
{
    Transform huge;
    huge.x = {1e300};
    huge.scale_x = rising(1, 1e250);
    huge.rotate = rising(0, -1e280);
    CHECK(loss_of(document({node("box", filled(box(-1e200, 1e100, 1e90, 1)), huge)})) != "");
}

TEST_CASE("thousands of nodes are written")
{
    std::vector<Node> nodes;
    nodes.reserve(5000);
    for (int i = 0; i < 5000; ++i)
        nodes.push_back(red_box("box"));
    CHECK(written_items({node("all", Group{std::move(nodes)})}).find("object box-5000 ") !=
          std::string::npos);
}

TEST_CASE("a drawing that comes again is a symbol, unless it is short")
{
    const art::Drawing open{{{{0, 0},
                              {scene::cubic_to({10, 0}, {20, 5}, {30, 0}),
                               scene::cubic_to({40.5, 10.5}, {130.5, 120.5}, {10, 9})},
                              true}}};
    const art::Drawing shut{
        {{{0, 8},
          {scene::cubic_to({10, 8}, {20, 9}, {30, 8}), scene::cubic_to({40, 8}, {30, 9}, {10, 9})},
          true}}};
    const Node eye =
        node("eye", filled(art::Animated<art::Drawing>{{{0, open, {}}, {10, shut, {}}, {20, open, {}}}}));
    const std::string items = written_items({eye});
    CHECK(items.starts_with("symbol eye-drawing { path \"M 0 0 C 10 0 20 5 30 0 C 40.5 10.5 130.5 120.5 10 9 "
                            "Z\" }\n\nobject eye"));
    CHECK(items.find("key 20 { use eye-drawing }") != std::string::npos);
}

}
