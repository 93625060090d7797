#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>
#include <sstream>

namespace kfast::test {
namespace {

SceneText object(const std::string& nodes) { return read_on_canvas("object o fill=red {\n" + nodes + "\n}"); }

/// What is found in one skeleton, the first line of which is 4.
std::string findings(const std::string& skeleton)
{
    return read_on_canvas("object o fill=red { key 0 { rect 0 0 9 9; skeleton {\n" + skeleton + "\n}}}")
        .findings;
}

/// What is found in a second skeleton behind one of two backbones with two and three nodes.
std::string findings_later(const std::string& skeleton)
{
    return object("key 0 { rect 0 0 9 9; skeleton { backbone 0 0 9 0; width 4; backbone 0 9 9 9 18 9; "
                  "width 2 } }\nkey 9 { skeleton { " +
                  skeleton + " } }")
        .findings;
}

std::string text_of(const std::vector<scene::Point>& points)
{
    std::ostringstream text;
    const char* between = "";
    for (const scene::Point point : points) {
        text << between << point.x << ',' << point.y;
        between = " ";
    }
    return text.str();
}

const scene::Backbone& backbone(const SceneText& text, std::size_t key = 0, std::size_t index = 0)
{
    REQUIRE(text.findings == "");
    return object_at(*text.scene).backbone_keys.at(key).backbones.at(index);
}

scene::Backbone banded(const std::string& nodes)
{
    return backbone(object("key 0 { rect 0 0 9 9; skeleton { " + nodes + " } }"));
}

}

TEST_CASE("a width puts a point on either side of each node, left as seen along them")
{
    const scene::Backbone straight = banded("backbone 10 20 30 20; width 8");
    CHECK(text_of(straight.nodes) == "160,320 480,320");
    CHECK(text_of(straight.left) == "160,256 480,256");
    CHECK(text_of(straight.right) == "160,384 480,384");
    const scene::Backbone down = banded("backbone 10 20 10 40; width 8");
    CHECK(text_of(down.left) == "224,320 224,640");
}

TEST_CASE("each node may have a width of its own")
{
    const scene::Backbone tapered = banded("backbone 0 0 10 0 20 0; width 8 4 0");
    CHECK(text_of(tapered.left) == "0,-64 160,-32 320,0");
    CHECK(text_of(tapered.right) == "0,64 160,32 320,0");
}

TEST_CASE("a band keeps its width where it bends, up to twice the distance")
{
    const scene::Backbone corner = banded("backbone 0 0 10 0 10 10; width 4");
    CHECK(text_of(corner.left) == "0,-32 192,-32 192,160");
    CHECK(text_of(corner.right) == "0,32 128,32 128,160");
    const scene::Backbone hairpin = banded("backbone 0 0 10 0 0 1; width 4");
    CHECK(hairpin.left[1].x > 160 + 60); // its mitre would be 20 times as long
    CHECK(hairpin.left[1].x <= 160 + 64);
    CHECK(text_of(banded("backbone 0 0 10 0 5 0; width 4").left) == "0,-32 160,-32 80,32");
}

TEST_CASE("the sides may be given")
{
    const scene::Backbone given = banded("backbone 0 0 10 0; right 0 5 10 6; left 0 -3 10 -2");
    CHECK(text_of(given.left) == "0,-48 160,-32");
    CHECK(text_of(given.right) == "0,80 160,96");
}

TEST_CASE("a skeleton may have several backbones, each with its own outline")
{
    const SceneText text = object("key 0 { rect 0 0 9 9; skeleton { backbone 0 0 9 0; width 4; "
                                  "backbone 0 9 9 9; left 0 7 9 7; right 0 8 9 10 } }");
    CHECK(text_of(backbone(text, 0, 0).left) == "0,-32 144,-32");
    CHECK(text_of(backbone(text, 0, 1).left) == "0,112 144,112");
}

TEST_CASE("keys have a drawing, a skeleton or both, and their laws govern both")
{
    const auto [scene, findings] =
        object("key 0 law=accelerate { rect 0 0 9 9; skeleton { backbone 0 0 9 0; width 4 } }\n"
               "key 5 law-x=hold { skeleton { backbone 0 0 9 9 } }\n"
               "key 9 { circle 9 9 r=5 }\n"
               "key 12 { skeleton { backbone 0 0 0 9 } }");
    REQUIRE(scene);
    CHECK(findings == "");
    const scene::Object& deformed = object_at(*scene);
    REQUIRE(deformed.keys.size() == 2);
    CHECK(deformed.keys[1].time == Time::frame(9));
    CHECK(deformed.keys[0].laws.x == VelocityLaw::accelerate);
    REQUIRE(deformed.backbone_keys.size() == 3);
    CHECK(deformed.backbone_keys[0].laws.y == VelocityLaw::accelerate);
    CHECK(deformed.backbone_keys[1].time == Time::frame(5));
    CHECK(deformed.backbone_keys[1].laws.x == VelocityLaw::hold);
    CHECK(deformed.backbone_keys[1].laws.y == VelocityLaw::constant);
    CHECK(deformed.backbone_keys[2].laws == LawPair{});
    CHECK(scene->length == Time::frame(12));
}

TEST_CASE("a key without an outline keeps the widths of the one before it")
{
    const SceneText text = object("key 0 { rect 0 0 9 9; skeleton { backbone 0 0 10 0; width 8 4 } }\n"
                                  "key 5 { skeleton { backbone 0 0 0 10 } }\n"
                                  "key 9 { skeleton { backbone 5 0 15 0; width 2 } }\n"
                                  "key 12 { skeleton { backbone 0 0 10 0 } }");
    CHECK(text_of(backbone(text, 1).left) == "64,0 32,160");
    CHECK(text_of(backbone(text, 3).left) == "0,-16 160,-16");
    CHECK(object("key 0 { rect 0 0 9 9; skeleton { backbone 0 0 9 0; left 0 2 9 2; right 0 3 9 3 } }\n"
                 "key 5 { skeleton { backbone 0 0 9 0 } }")
              .findings ==
          "5:20 error: this backbone has no width (write width PIXELS behind it, or left and "
          "right)");
}

TEST_CASE("shapes may stand beside keys that have only skeletons")
{
    const auto [scene, findings] = object("key 0 { skeleton { backbone 0 0 9 0; width 4 } }\nrect 0 0 9 9\n"
                                          "key 9 law=hold { skeleton { backbone 0 0 0 9 } }\n"
                                          "key 12 { skeleton { backbone 0 0 9 9 } }");
    REQUIRE(scene);
    CHECK(findings == "");
    CHECK(object_at(*scene).keys.size() == 1);
    CHECK(object_at(*scene).backbone_keys.size() == 3);
}

TEST_CASE("a symbol's drawing may be carried")
{
    const auto [scene, findings] =
        read_on_canvas("symbol s { key 0 { rect 0 0 9 9 }; key 9 { rect 0 0 5 5 } }\n"
                       "object o fill=red { use s; key 3 { skeleton { backbone 0 0 9 0; width 4 } } }");
    REQUIRE(scene);
    CHECK(findings == "");
    CHECK(object_at(*scene).keys.size() == 2);
    CHECK(object_at(*scene).backbone_keys.size() == 1);
}

TEST_CASE("the default pivot is that of the first drawing, whatever carries it")
{
    CHECK(items_read("object o fill=red rotate=90 { key 0 { skeleton { backbone 0 0 90 0; width 40 } }\n"
                     "key 5 { rect 10 20 20 20 } }") ==
          "object o @5 rotation[16384] pivot_x[320] pivot_y[480]");
}

TEST_CASE("laws and matches of keys that have only skeletons are looked at")
{
    const std::string skeleton = "{ skeleton { backbone 0 0 9 0; width 4 } }";
    CHECK(object("rect 0 0 9 9\nkey 0 " + skeleton + "\nkey 5 law=hold " + skeleton).findings ==
          "6:7 warning: this law governs nothing (remove it, or let a later key set what this one sets)");
    CHECK(object("key 0 { rect 0 0 9 9 }\nkey 5 law-y=hold match=length " + skeleton + "\nkey 9 { empty }")
              .findings ==
          "5:7 warning: this law-y governs nothing (remove it, or let a later key set what this one sets)\n"
          "5:18 warning: this match governs nothing (remove it, or let a later key set what this one sets)");
}

TEST_CASE("nodes of a skeleton that do not fit")
{
    CHECK(findings("backbone 1 2") == "4:1 error: backbone needs more values (write backbone X Y X Y …)");
    CHECK(findings("backbone 1 2 3 4 5; width 2") ==
          "4:18 error: this x has no y (add the y, or remove this x)");
    CHECK(findings("backbone 1 2 3 4 closed=#true; width 2") ==
          "4:18 error: backbone has no property \"closed\" (nothing is allowed here)");
    CHECK(findings("backbone 1 2 3 4 3.01 4 9 9; width 2") ==
          "4:18 error: this node lies where the one before it does (move it, by 1/16 px at least, or remove "
          "it)");
    CHECK(findings("bakbone 1 2 3 4") ==
          "4:1 error: a skeleton has no node \"bakbone\" (did you mean \"backbone\"?)");
    CHECK(findings("width 3; backbone 1 2 3 4; width 3") ==
          "4:1 error: this width has no backbone in front of it (write it behind the backbone that it "
          "belongs to)");
    CHECK(findings("") == "3:43 error: this skeleton has no backbone (write backbone X Y X Y … into it)");
    CHECK(object("key 0 { rect 0 0 9 9; skeleton x { backbone 1 2 3 4; width 2 } }").findings ==
          "4:32 error: this value is too many for skeleton (write skeleton { backbone X Y X Y …; width "
          "PIXELS })");
    CHECK(object("key 0 { rect 0 0 9 9; skeleton width=2 { backbone 1 2 3 4 } }").findings ==
          "4:32 error: skeleton has no property \"width\" (nothing is allowed here)");
}

TEST_CASE("outlines that do not fit")
{
    CHECK(findings("backbone 0 0 9 0") == "4:1 error: this backbone has no width "
                                          "(write width PIXELS behind it, or left and right)");
    CHECK(findings("backbone 0 0 9 0; width 1 2 3") ==
          "4:19 error: there are 3 widths here, the backbone has 2 nodes "
          "(give one width for all nodes, or one for each)");
    CHECK(findings("backbone 0 0 9 0; width -1") ==
          "4:25 error: this number is out of range (allowed: 0 to 4094)");
    CHECK(findings("backbone 0 0 9 0; width 1; width 2") ==
          "4:28 error: this backbone has its width already, on line 4 (remove one of them)");
    CHECK(findings("backbone 0 0 9 0; left 0 1 9 1") == "4:19 error: this side has no other one "
                                                        "(a backbone has both left and right, or a width)");
    CHECK(findings("backbone 0 0 9 0; width 2; right 0 1 9 1") ==
          "4:19 error: a backbone has either a width or a left and a right side (remove one of them)");
    CHECK(findings("backbone 0 0 9 0; left 0 1 9 1; right 0 2 9 2 12 3") ==
          "4:33 error: this side has 3 points, its backbone has 2 nodes (give it one point for each node)");
    CHECK(findings("backbone 0 0 9 0; left 0 0 9 0; right 0 2 9 2") ==
          "4:19 error: the backbone has no width between its nodes 1 and 2 (make it wider at one of them at "
          "least)");
    CHECK(findings("backbone 0 0 9 0 12 0 15 0; width 4 0 0.05 0") ==
          "4:29 error: the backbone has no width between its nodes 2 and 3 (make it wider at one of them at "
          "least)");
    CHECK(findings("backbone 0 0 9 0; width 4094") == "");
    CHECK(findings("backbone -2047 -2047 2047 2047; left 2047 -2047 2047 2047; right -2047 2047 0 2047") ==
          "");
    CHECK(findings("backbone 0 1 9 1; width 4094") ==
          "4:1 error: the outline of this backbone reaches more than 2047 px from the origin");
}

TEST_CASE("all skeletons of an object have the same form")
{
    CHECK(findings_later("backbone 0 0 9 0; backbone 0 9 9 9 18 9") == "");
    CHECK(findings_later("backbone 0 0 9 0") ==
          "5:9 error: this skeleton has 1 backbone, the one before it 2 "
          "(all skeletons of an object have the same number of backbones)");
    CHECK(findings_later("backbone 0 0 9 0; backbone 0 9 9 9") ==
          "5:38 error: this backbone has 2 nodes, in the skeleton before it 3 "
          "(all skeletons of an object have the same number of nodes)");
}

TEST_CASE("skeletons have limits")
{
    std::string many;
    for (int i = 0; i < 33; ++i)
        many += "backbone 0 " + std::to_string(i) + " 9 9; width 1\n";
    CHECK(findings(many) == "36:1 error: a skeleton has at most 32 backbones");
    std::string longest = "backbone";
    for (int i = 0; i < 257; ++i)
        longest.append(" ").append(std::to_string(i)).append(" 0");
    CHECK(findings(longest + "; width 4") ==
          "3:43 error: the backbones of this skeleton have 256 segments between their nodes, more than 255 "
          "(use fewer nodes)");
}

TEST_CASE("a skeleton stands in a key of an object, once, and carries a drawing")
{
    const std::string skeleton = "skeleton { backbone 0 0 9 0; width 4 }";
    CHECK(object("rect 0 0 9 9\n" + skeleton).findings ==
          "5:1 error: a skeleton stands in a key of an object (write key 0 { skeleton { … } })");
    CHECK(object("key 0 { rect 0 0 9 9; " + skeleton + "; " + skeleton + " }").findings ==
          "4:63 error: this key has a skeleton already (put all backbones into one skeleton)");
    CHECK(object("key 0 { " + skeleton + " }").findings ==
          "3:1 error: this object has no drawing (add shapes to the object or to its keys)");
    CHECK(read_on_canvas("symbol s { key 0 { rect 0 0 9 9; " + skeleton + " } }\nobject o fill=red { use s }")
              .findings == "3:34 error: the key of a symbol has no skeleton "
                           "(put it into a key of the object that uses the symbol)");
    CHECK(
        read_on_canvas("group { object o fill=red { rect 0 0 9 9 }; key 0 { " + skeleton + " } }").findings ==
        "3:53 error: key takes no nodes inside (write key TIME law=LAW x=X …)");
    CHECK(
        read_on_canvas("object o fill=red skin=s { rect 0 0 9 9; key 0 { " + skeleton + " } }")
            .findings.find("3:50 error: this object has a skin; bones or backbones carry an object, not both "
                           "(remove the skin, or the skeletons from the keys)") != std::string::npos);
}

}
