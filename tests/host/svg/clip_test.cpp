#include "tests/host/svg/drawing_text.hpp"

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

TEST_CASE("a clip that takes something away is lost")
{
    CHECK(losses("<clipPath id='c'><rect x='21' y='20' width='20' height='20'/></clipPath>", part) == 1);
    CHECK(losses("<clipPath id='c'><circle cx='30' cy='30' r='13'/></clipPath>", part) == 1);
    CHECK(losses("<clipPath id='c' transform='translate(50 0)'><rect width='100' height='100'/></clipPath>",
                 part) == 1);
    CHECK(losses("<clipPath id='c'><path d='M0 0H60V60H0V30H35V25H0z'/></clipPath>", part) == 1);
    CHECK(losses("<clipPath id='c'/>", part) == 1);
    CHECK(losses("<clipPath id='c'><rect width='100' height='100'/></clipPath>",
                 "<g transform='translate(90 0)'>" + part + "</g>") == 0);
    CHECK(losses("<clipPath id='c'><rect width='39' height='90'/></clipPath>",
                 "<g transform='translate(-30 0)'>" + part + "</g>") == 1);
}

TEST_CASE("a white mask over all is no loss, a grey one is")
{
    const std::string masked = "<rect x='20' y='20' width='20' height='20' mask='url(#c)'/>";
    CHECK(losses("<mask id='c'><rect width='100' height='100' fill='white'/></mask>", masked) == 0);
    CHECK(losses("<mask id='c'><rect width='100' height='100' fill='gray'/></mask>", masked) == 1);
    CHECK(losses("<mask id='c' style='mask-type:alpha'><rect width='100' height='100'/></mask>", masked) ==
          0);
}

TEST_CASE("what a nested drawing would cut off is told")
{
    CHECK(
        losses_of("<svg x='10' y='10' width='20' height='20'><circle r='5' cx='10' cy='10'/></svg>").empty());
    CHECK(losses_of("<svg x='10' y='10' width='20' height='20'><circle r='5'/></svg>") ==
          std::vector<std::string>{"overflow hidden | svg | seen beyond the box as well"});
    CHECK(losses_of("<svg x='10' y='10' width='20' height='20' overflow='visible'><circle r='5'/></svg>")
              .empty());
}
