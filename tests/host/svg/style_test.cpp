#include "tests/host/svg/drawing_text.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

/// Of the figure "it".
std::string fill(std::string_view content)
{
    const auto found = shape(read_drawing(content), "it").fill;
    return found ? hex(found->colour.value()) : "none";
}

/// Of a rectangle with a style sheet and attributes, in a group.
std::string styled(const std::string& css, const std::string& attributes, const std::string& group = "")
{
    return fill("<style>" + css + "</style><g " + group +
                "><rect id='it' width='9' height='9' stroke='red' " + attributes + "/></g>");
}

const art::StrokeStyle& stroke(const art::Document& document) { return *shape(document, "it").stroke; }

}

TEST_CASE("attributes yield to style sheets, these to the element's own style")
{
    CHECK(styled("", "") == "#000000");
    CHECK(styled("", "fill='lime'") == "#00ff00");
    CHECK(styled("rect{fill:blue}", "fill='lime'") == "#0000ff");
    CHECK(styled("rect{fill:blue}", "style='fill:red;'") == "#ff0000");
    CHECK(styled("rect{fill:blue !important}", "style='fill:red'") == "#0000ff");
    CHECK(styled("rect{fill:blue!important}", "style='fill:red ! important'") == "#ff0000");
}

TEST_CASE("the more special selector wins, of equals the later one")
{
    CHECK(styled(".a{fill:blue} rect{fill:red}", "class='b a'") == "#0000ff");
    CHECK(styled("#it{fill:blue} .a.b{fill:red}", "class='b a'") == "#0000ff");
    CHECK(styled(".a{fill:red} .b{fill:blue}", "class='b a'") == "#0000ff");
    CHECK(styled("rect.a{fill:blue} .b{fill:red}", "class='b a'") == "#0000ff");
    CHECK(styled("*{fill:blue}", "class='b a'") == "#0000ff");
    CHECK(styled(".ab{fill:red} .a-b{fill:red}", "class='a b'") == "#000000");
}

TEST_CASE("selectors of elements around")
{
    CHECK(styled("g rect{fill:blue}", "") == "#0000ff");
    CHECK(styled("svg rect{fill:blue}", "") == "#0000ff");
    CHECK(styled("svg > rect{fill:blue}", "") == "#000000");
    CHECK(styled("svg>g>rect{fill:blue}", "") == "#0000ff");
    CHECK(styled(".warm rect, circle {fill:blue}", "", "class='warm'") == "#0000ff");
    CHECK(styled("svg .warm #it{fill:blue}", "", "class='warm'") == "#0000ff");
}

TEST_CASE("comments, media and rules that have nothing to say here")
{
    CHECK(styled("/* rect{fill:red} */ rect{fill:/**/blue}", "") == "#0000ff");
    CHECK(styled("@charset 'utf-8'; @font-face{font-family:x} rect{fill:blue}", "") == "#0000ff");
    CHECK(styled("@media screen { rect{fill:blue} }", "") == "#0000ff");
    CHECK(styled("rect:hover{fill:red}", "") == "#000000");
}

TEST_CASE("colours are inherited, by name as well")
{
    CHECK(styled("", "", "fill='lime'") == "#00ff00");
    CHECK(styled("", "fill='currentColor'", "color='lime'") == "#00ff00");
    CHECK(styled("", "fill='inherit'", "fill='lime'") == "#00ff00");
    CHECK(styled("", "fill='initial'", "fill='lime'") == "#000000");
    CHECK(styled("", "fill='none'", "fill='lime'") == "none");
    CHECK(styled(":root{--x:red}", "", "") == "#000000");
    CHECK(styled("g{--tone: lime} rect{fill:var(--tone)}", "") == "#00ff00");
    CHECK(styled("rect{fill:var(--none, blue)}", "") == "#0000ff");
}

TEST_CASE("pens")
{
    const auto document = read_drawing(R"(
        <g stroke-linecap="round" stroke-linejoin="bevel"><path id="it" d="M0 0h9" stroke='rgba(255,0,0,.5)'
        stroke-opacity="50%" stroke-width="1cm" stroke-miterlimit="7"/></g>)");
    CHECK(stroke(document).width.value() == doctest::Approx(96 / 2.54));
    CHECK(stroke(document).opacity.value() == doctest::Approx(0.25));
    CHECK(stroke(document).cap == Cap::round);
    CHECK(stroke(document).join == Join::bevel);
    CHECK(stroke(document).miter_limit == 7);
}

TEST_CASE("a pen grows with what it draws, if it is not to keep its width")
{
    const auto width = [](const std::string& attributes) {
        return stroke(read_drawing("<path id='it' d='M0 0h9' stroke='red' " + attributes + "/>"))
            .width.value();
    };
    CHECK(width("transform='scale(3)'") == doctest::Approx(3));
    CHECK(width("transform='rotate(30) scale(-2 2)' stroke-width='2'") == doctest::Approx(4));
    CHECK(width("transform='scale(3)' vector-effect='non-scaling-stroke'") == doctest::Approx(1));
    CHECK(width("stroke-width='10%'") == doctest::Approx(10));
}

TEST_CASE("the fill rule, and the opacities of fill and element")
{
    const auto document = read_drawing(R"(
        <path id="it" d="M0 0h9v9z" fill="red" fill-rule="evenodd" fill-opacity=".5" opacity="40%"/>)");
    CHECK(shape(document, "it").fill->rule == FillRule::even_odd);
    CHECK(shape(document, "it").fill->opacity.value() == 0.5);
    CHECK(find(document, "it").opacity.value() == 0.4);
}

TEST_CASE("a gradient is its mean colour, by the lengths of its pieces and by what is seen")
{
    const std::string gradients = R"(<defs>
        <linearGradient id="even"><stop offset="0" stop-color="red"/><stop offset="1" stop-color="blue"/></linearGradient>
        <linearGradient id="late" href="#even"/>
        <linearGradient id="mostly"><stop offset="0.5" stop-color="red"/><stop offset="1" stop-color="blue"/></linearGradient>
        <radialGradient id="clear"><stop offset="0" stop-color="red"/><stop offset="1" stop-color="blue" stop-opacity="0"/></radialGradient>
        <linearGradient id="self" href="#self"/>
        </defs>)";
    const auto painted = [&](const std::string& id) {
        auto found =
            gradients + "<rect id='it' width='9' height='9' stroke='red' fill='url(#" + id + ") lime'/>";
        CHECK(losses_of(found).size() == (id == "self" || id == "nothing" ? 0 : 1));
        return found;
    };
    struct Mean {
        std::string id;
        std::string colour;
        double opacity;
    };
    for (const Mean& mean : {Mean{"even", "#800080", 1}, Mean{"late", "#800080", 1},
                             Mean{"mostly", "#bf0040", 1}, Mean{"clear", "#ff0000", 0.5}}) {
        CAPTURE(mean.id);
        const auto document = read_lossy(painted(mean.id));
        CHECK(hex(shape(document, "it").fill->colour.value()) == mean.colour);
        CHECK(shape(document, "it").fill->opacity.value() == doctest::Approx(mean.opacity));
    }
    CHECK(fill(painted("nothing")) == "#00ff00");
}

TEST_CASE("style sheets of other languages are none")
{
    CHECK(fill("<style type='text/css'>rect{fill:red}</style><rect id='it' width='9' height='9'/>") ==
          "#ff0000");
    CHECK(fill("<style type='text/less'>rect{fill:red}</style><rect id='it' width='9' height='9'/>") ==
          "#000000");
}
