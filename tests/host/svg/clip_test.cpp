#include "tests/host/svg/drawing_text.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::size_t losses(const std::string& clip, const std::string& content)
{
    return losses_of("<defs>" + clip + "</defs>" + content).size();
}

const std::string part = "<rect x='20' y='20' width='20' height='20' clip-path='url(#c)'/>";

}

TEST_CASE("a clip that takes nothing away is no loss")
{
    CHECK(losses("<clipPath id='c'><rect width='100' height='100'/></clipPath>", part) == 0);
    CHECK(losses("<clipPath id='c'><rect x='20' y='20' width='20' height='20'/></clipPath>", part) == 0);
    CHECK(losses("<clipPath id='c'><circle cx='30' cy='30' r='15'/></clipPath>", part) == 0);
    CHECK(losses("<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='1' height='1'/></clipPath>",
                 part) == 0);
    CHECK(losses("", part) == 0);
}

namespace {

/// Of what is left of a 20 x 20 rectangle at (20, 20).
std::vector<double> rest(const std::string& clip)
{
    return box(shape(read_drawing("<defs>" + clip + "</defs>" + part), "rect").drawing.value());
}

using Corners = std::vector<double>;

}

TEST_CASE("a clip cuts fills")
{
    CHECK(rest("<clipPath id='c'><rect x='25' y='10' width='20' height='20'/></clipPath>") ==
          Corners{25, 20, 40, 30});
    CHECK(rest("<clipPath id='c' transform='translate(5 -10)'><rect x='20' y='20' width='20' "
               "height='20'/></clipPath>") == Corners{25, 20, 40, 30});
    CHECK(
        rest("<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/></clipPath>") ==
        Corners{20, 20, 30, 40});
    CHECK(rest("<clipPath id='c'><rect x='25' y='10' width='20' height='20' fill='none'/></clipPath>") ==
          Corners{25, 20, 40, 30});
    CHECK(rest("<rect id='r' x='25' y='10' width='20' height='20'/><clipPath id='c'><use "
               "href='#r'/></clipPath>") == Corners{25, 20, 40, 30});
    CHECK(rest("<clipPath id='c' clipPathUnits='objectBoundingBox' transform='translate(5 0)'>"
               "<rect width='.5' height='1'/></clipPath>") == Corners{25, 20, 35, 40});
    CHECK(rest("<clipPath id='c' transform='scale(.5)' transform-origin='30 30'>"
               "<rect x='20' y='20' width='20' height='20'/></clipPath>") == Corners{25, 25, 35, 35});
}

TEST_CASE("what lies outside of a clip is not drawn")
{
    CHECK(read_drawing("<clipPath id='c'><rect width='9' height='9'/></clipPath>" + part).nodes.empty());
    CHECK(read_drawing("<clipPath id='c'/>" + part).nodes.empty());
    CHECK(read_drawing("<clipPath id='c'><rect display='none' width='9' height='9'/></clipPath>" + part)
              .nodes.empty());
}

TEST_CASE("curves that are cut stay curves")
{
    const auto document = read_drawing("<clipPath id='c'><rect width='50' height='99'/></clipPath>"
                                       "<circle id='left' cx='50' cy='50' r='20' clip-path='url(#c)'/>"
                                       "<clipPath id='d'><circle cx='50' cy='50' r='20'/></clipPath>"
                                       "<rect id='up' y='0' width='99' height='50' clip-path='url(#d)'/>");
    const auto near = [](const std::vector<double>& one, const std::vector<double>& other) {
        return std::ranges::equal(one, other, [](double a, double b) { return std::abs(a - b) < 0.01; });
    };
    const auto& left = shape(document, "left").drawing.value();
    CHECK(near(box(left), {30, 30, 50, 70}));
    CHECK(left.outlines.front().curves.size() == 3);
    const auto& up = shape(document, "up").drawing.value();
    CHECK(near(box(up), {30, 30, 70, 50}));
    CHECK(up.outlines.front().curves.size() <= 4);
}

TEST_CASE("a clip reaches into groups, through their transforms")
{
    const auto document =
        read_drawing("<clipPath id='c'><rect x='20' y='20' width='20' height='20'/></clipPath>"
                     "<g clip-path='url(#c)' transform='translate(10 0)'><rect id='in' x='25' y='25' "
                     "width='5' height='5' stroke='red'/>"
                     "<g transform='scale(2)'><rect id='over' x='15' y='15' width='9' height='2'/></g><rect "
                     "id='out' width='9' height='9'/></g>");
    CHECK(box(shape(document, "in").drawing.value()) == Corners{35, 25, 40, 30});
    CHECK(box(shape(document, "over").drawing.value()) == Corners{40, 30, 50, 34});
    CHECK(document.nodes.size() == 2);
}

TEST_CASE("the clip of a use lies where the use does, before its x and y")
{
    const auto document =
        read_drawing("<defs><rect id='r' width='20' height='20'/></defs>"
                     "<clipPath id='c'><rect x='15' y='0' width='90' height='90'/></clipPath>"
                     "<use id='u' href='#r' x='10' clip-path='url(#c)'/>");
    CHECK(box(shape(document, "u").drawing.value()) == Corners{15, 0, 30, 20});
}

TEST_CASE("a clip of the outermost element holds for all")
{
    const auto document = read_drawing("<clipPath id='c'><rect width='30' height='90'/></clipPath>"
                                       "<rect x='20' y='20' width='20' height='20'/>",
                                       "width='100' height='100' clip-path='url(#c)'");
    CHECK(box(shape(document, "rect").drawing.value()) == Corners{20, 20, 30, 40});
}

TEST_CASE("a clip that cannot be cut is lost")
{
    CHECK(losses("<clipPath id='c'><path d='M0 0H60V60H0V30H35V25H0z'/></clipPath>", part) == 1);
    CHECK(
        losses(
            "<clipPath id='c'><rect width='30' height='90'/><rect x='5' width='30' height='90'/></clipPath>",
            part) == 1);
    CHECK(losses("<clipPath id='c'><text>A</text></clipPath>", part) == 1);
    CHECK(losses("<clipPath id='c' style='clip-path:url(#d)'><rect width='90' "
                 "height='90'/></clipPath><clipPath id='d'/>",
                 part) == 1);
    CHECK(losses("<clipPath id='c'><rect width='30' height='90'/></clipPath>",
                 "<rect x='20' y='20' width='20' height='20' stroke='red' clip-path='url(#c)'/>") == 1);
    CHECK(losses("<clipPath id='c'><rect width='100' height='100'/></clipPath>",
                 "<g transform='translate(90 0)'>" + part + "</g>") == 0);
}

TEST_CASE("a white mask over all is no loss, a grey one is")
{
    const std::string masked = "<rect x='20' y='20' width='20' height='20' mask='url(#c)'/>";
    CHECK(losses("<mask id='c'><rect width='100' height='100' fill='white'/></mask>", masked) == 0);
    CHECK(losses("<mask id='c'><rect width='100' height='100' fill='gray'/></mask>", masked) == 1);
    CHECK(losses("<mask id='c' style='mask-type:alpha'><rect width='100' height='100'/></mask>", masked) ==
          0);
    CHECK(losses("<mask id='c'><rect width='30' height='100' fill='white'/></mask>", masked) == 0);
    CHECK(losses("<mask id='c' width='.5'><rect width='100' height='100' fill='white'/></mask>", masked) ==
          1);
    CHECK(
        losses(
            "<mask id='c' mask='url(#d)'><rect width='100' height='100' fill='white'/></mask><mask id='d'/>",
            masked) == 1);
}

TEST_CASE("a nested drawing cuts at its edge")
{
    CHECK(
        losses_of("<svg x='10' y='10' width='20' height='20'><circle r='5' cx='10' cy='10'/></svg>").empty());
    const auto document =
        read_drawing("<svg x='10' y='10' width='20' height='20'><rect x='-5' width='9' height='9'/></svg>");
    CHECK(box(shape(document, "rect").drawing.value()) == Corners{10, 10, 14, 19});
    const auto with_room = read_drawing("<svg x='10' y='10' width='20' height='20' viewBox='0 0 10 5'>"
                                        "<rect width='10' height='9'/></svg>");
    CHECK(box(shape(with_room, "rect").drawing.value()) == Corners{10, 15, 30, 30});
    CHECK(losses_of("<svg x='10' y='10' width='20' height='20'><circle r='5' stroke='red'/></svg>") ==
          std::vector<std::string>{"overflow hidden | svg / circle | the line is drawn whole"});
    CHECK(losses_of("<svg x='10' y='10' width='20' height='20' overflow='visible'><circle r='5'/></svg>")
              .empty());
}
