#include "host/svg/read_svg.hpp"
#include "tests/host/svg/drawing_text.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {
using Lines = std::vector<std::string>;
}

TEST_CASE("what is not drawn is told, with its words and its place")
{
    CHECK(losses_of("<g inkscape:label='body'><text id='t'>Hello  <tspan>all</tspan></text></g>") ==
          Lines{"text \"Hello all\" | body | nothing: turn it into a path"});
    CHECK(losses_of("<image/>") == Lines{"<image> |  | nothing: only shapes are drawn"});
    CHECK(
        losses_of("<rect id='r' width='3' height='3'><title>t</title><animate attributeName='x'/></rect>") ==
        Lines{"<animate> | r | its values at rest"});
    CHECK(losses_of("<rect id='r' width='3' height='3'/><use id='u' href='#r'><set/></use>") ==
          Lines{"<set> | u | its values at rest"});
    CHECK(losses_of("<blob/>") == Lines{"<blob> |  | nothing"});
    CHECK(losses_of("<rect width='3' height='3' filter='url(#f)'/>") ==
          Lines{"filter | rect | drawn without it"});
    CHECK(losses_of("<rect width='3' height='3' fill='blurple'/>") ==
          Lines{"fill \"blurple\" | rect | nothing is painted"});
    CHECK(losses_of("<rect width='3' height='3' style='quux:1' glow='2' onclick='x'/>") ==
          Lines{"property \"quux\" | rect | it is ignored", "attribute \"glow\" | rect | it is ignored",
                "script of \"onclick\" | rect | it does not run"});
    CHECK(losses_of("<path id='p' d='M0 0L9 9 L 3'/>").size() == 1);
    CHECK(losses_of("<use href='#x'/>").size() == 1);
    CHECK(losses_of("<use href='other.svg#x'/>").size() == 1);
    CHECK(losses_of("<style>@import 'x'; a[b]{fill:red} @keyframes k{to{fill:red}}</style>").size() == 3);
    CHECK(losses_of("<path d='M0 0h9' stroke='red' transform='scale(3 1)'/>").size() == 1);
    CHECK(losses_of("<rect width='3' height='3' transform='rotate3d(1,1,1,4deg)'/>").size() == 1);
    CHECK(losses_of("<path d='M0 0h9' stroke='red' stroke-dasharray='.01'/>").size() == 1);
    CHECK(losses_of("<path d='M0 0h9' stroke='red' stroke-linejoin='arcs'/>").size() == 1);
    CHECK(losses_of("<pattern id='p'/><rect width='3' height='3' fill='url(#p)'/>") ==
          Lines{"pattern | rect | nothing"});
    CHECK(losses_of(
              "<pattern id='p' width='4' height='4' patternUnits='userSpaceOnUse'><circle r='1'/></pattern>"
              "<rect width='3' height='3' fill='url(#p)'/>") == Lines{"pattern | rect | its mean colour"});
    CHECK(losses_of("<marker id='m'/><path d='M0 0h9' stroke='red' marker='url(#m)'/>") ==
          Lines{"marker | path | the line without it"});
    CHECK(losses_of("<rect width='3' height='3' transform='scale(1e9)'/>").size() == 1);
}

TEST_CASE("lengths that are none are told, and none is taken for another")
{
    CHECK(losses_of("<rect width='3' height='calc(1px + 2px)'/>") ==
          Lines{"height: calc(1px + 2px) | rect | it is as if it were not set"});
    CHECK(losses_of("<line x1='one' x2='9' stroke='red'/>") ==
          Lines{"x1: one | line | it is as if it were not set"});
    CHECK(losses_of("<path d='M0 0h9' stroke='red' stroke-width='thick' stroke-dashoffset='x'/>") ==
          Lines{"stroke-width: thick | path | it is as if it were not set",
                "stroke-dashoffset: x | path | it is as if it were not set"});
    CHECK(losses_of("<path d='M0 0h9' stroke='red' stroke-dasharray='2 much'/>") ==
          Lines{"stroke-dasharray: 2 much | path | the whole line"});
    CHECK(losses_of("<polygon points='0 0 9 0 9 9 x'/>") ==
          Lines{"points: 0 0 9 0 9 9 x | polygon | those up to the mistake"});
    for (const char* const far : {"<rect x='1e9' width='5' height='5'/>", "<rect width='1e12' height='5'/>",
                                  "<polygon points='0 0 1e9 0 9 9'/>"})
        CHECK(losses_of(far).size() == 1);
    CHECK(losses_of("<rect width='3' height='3' rx='auto'/>").empty());
}

TEST_CASE("what has no effect on the picture is not told")
{
    CHECK(losses_of(R"(
        <title>A</title><desc>b</desc><metadata><rdf xmlns="x"/></metadata><inkscape:grid/><!-- c -->
        <defs><filter id="f"/><pattern/><font/></defs>
        <g inkscape:groupmode="layer" data-x="1" aria-label="x" role="img" xml:space="preserve" font-family="Arial"
           style="font-variant-ligatures:none;-inkscape-stroke:none;filter:none;mix-blend-mode:normal;isolation:auto;
           cursor:pointer;white-space:pre;color-rendering:auto;solid-color:#000;text-anchor:start">
        <rect width="3" height="3" clip-path="none" mask="none" marker-end="none" shape-rendering="crispEdges"/></g>
        <text display="none">x</text><g display="none"><image/></g><image visibility="hidden"/>)")
              .empty());
}

TEST_CASE("a pattern is painted as its mean colour")
{
    const auto fill = [](const std::string& attributes, const std::string& content) {
        const auto document = read_lossy("<pattern id='p' " + attributes + ">" + content +
                                         "</pattern><rect id='it' width='20' height='10' fill='url(#p)'/>");
        if (document.nodes.empty())
            return std::string{"nothing"};
        const auto& found = *shape(document, "it").fill;
        return hex(found.colour.value()) + ' ' + std::to_string(std::lround(100 * found.opacity.value()));
    };
    const std::string of_user = "width='4' height='4' patternUnits='userSpaceOnUse'";
    const std::string half = "<rect width='4' height='2' fill='red'/>";
    CHECK(fill(of_user, half) == "#ff0000 50");
    CHECK(fill(of_user, "<rect width='4' height='4' fill='blue'/>" + half) == "#800080 100");
    CHECK(fill(of_user, "<g transform='scale(2)'><path d='M0 1H2' stroke='red' stroke-width='1'/></g>") ==
          "#ff0000 50");
    CHECK(fill("width='.1' height='.2'", "<rect width='2' height='1' fill='red'/>") == "#ff0000 50");
    CHECK(fill("width='9' height='9' viewBox='0 0 8 2'", half) == "#ff0000 50");
    CHECK(fill("href='#q'", "") == "nothing");
    CHECK(fill(of_user, "<rect width='4' height='2' fill='url(#p)'/>") == "nothing");
    CHECK(fill(of_user, "") == "nothing");
}

TEST_CASE("what uses itself is told by its name, and not drawn")
{
    CHECK(losses_of("<use id='a' href='#a'/>") == Lines{"\"a\" inside of itself | a | nothing"});
    CHECK(losses_of("<g id='a'><circle r='3'/><use href='#b'/></g><g id='b'><use href='#a'/></g>") ==
          Lines{"\"a\" inside of itself | a / use / b / use | nothing",
                "\"b\" inside of itself | b / use / a / use | nothing"});
    CHECK(losses_of("<symbol id='s'><use href='#s'/></symbol><use href='#s'/>") ==
          Lines{"\"s\" inside of itself | use / s / use | nothing"});
    CHECK(losses_of("<clipPath id='c'><circle r='3' clip-path='url(#c)'/></clipPath>"
                    "<circle r='9' clip-path='url(#c)'/>") == Lines{"clip-path | circle | drawn whole"});
}

TEST_CASE("what is for other languages, or needs extensions, is told")
{
    CHECK(losses_of("<rect width='3' height='3' systemLanguage='ru, de-AT'/>") ==
          Lines{"systemLanguage \"ru, de-AT\" |  | nothing: kfast draws what is for English, and without "
                "extensions"});
    CHECK(losses_of("<rect width='3' height='3' systemLanguage=''/>").size() == 1);
    CHECK(losses_of("<rect width='3' height='3' requiredExtensions='x'/>").size() == 1);
    CHECK(losses_of("<rect width='3' height='3' systemLanguage='ru, en-GB'/>").empty());
    CHECK(losses_of("<switch><rect systemLanguage='ru'/><rect width='3' height='3'/></switch>").empty());
}

TEST_CASE("a canvas without a size of its own kind is told")
{
    art::Losses losses;
    svg::read_svg({"a.svg", drawing("", "width='0' height='-3'")}, losses);
    CHECK(losses.list().size() == 1);
    CHECK(losses_of("<g/>").empty());
    art::Losses of_root;
    svg::read_svg({"a.svg", drawing("", "width='9' height='9' transform='scale(2)'")}, of_root);
    CHECK(of_root.list().size() == 1);
}
