#include "host/program/failure.hpp"
#include "host/svg/read_svg.hpp"
#include "tests/host/svg/drawing_text.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <string>

using namespace kfast;
using namespace kfast::test;

namespace {

bool begins(const std::string& text, const std::string& beginning) { return text.starts_with(beginning); }

std::string nested(const std::string& name, int depth, const std::string& content)
{
    std::string opening;
    std::string closing;
    for (int i = 0; i < depth; ++i) {
        opening += "<" + name + ">";
        closing += "</" + name + ">";
    }
    return opening + content + closing;
}

std::string keys_failure(std::size_t drawings, const std::vector<double>& times)
{
    art::Losses losses;
    std::vector<std::string> notes;
    const std::vector<SourceText> sources(drawings, SourceText{"pose.svg", drawing("<circle r='3'/>")});
    try {
        svg::read_svg_keys(sources, times, {}, losses, notes);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return {};
}

}

TEST_CASE("what is no XML is refused with its line and column")
{
    CHECK(begins(failure_of("<svg>\n  <g></h>\n</svg>"), "test.svg:2:"));
    CHECK(begins(failure_of("<svg"), "test.svg:1:"));
    CHECK_FALSE(failure_of("").empty());
    CHECK_FALSE(failure_of("{}").empty());
    CHECK_FALSE(failure_of(std::string("<svg\0/>", 7)).empty());
}

TEST_CASE("a text of too many tags is refused before they take any memory")
{
    CHECK(failure_of(drawing(std::string(2'097'150, '<'))).find("this is no XML") != std::string::npos);
    CHECK(failure_of(drawing(std::string(2'097'151, '<'))).find("more than 2097152 tags") !=
          std::string::npos);
}

TEST_CASE("what is no drawing is refused")
{
    CHECK(failure_of("<html/>") == "test.svg: there is no drawing in it: its outermost element is not <svg>");
    CHECK(failure_of("<svg/>").empty());
}

TEST_CASE("uses of uses are refused before they become too many")
{
    std::string text = "<circle id='u0' r='3'/>";
    for (int i = 1; i < 30; ++i) {
        const std::string use = "<use href='#u" + std::to_string(i - 1) + "'/>";
        text += "<g id='u" + std::to_string(i) + "'>" + use + use + "</g>";
    }
    CHECK(failure_of(drawing(text)).find("65535") != std::string::npos);
}

TEST_CASE("groups in groups are refused where they are too deep")
{
    CHECK(failure_of(drawing(nested("g", 40, "<circle r='3'/>"))).empty());
    CHECK(failure_of(drawing(nested("g", 100, "<circle r='3'/>"))).find("deep") != std::string::npos);
    CHECK(failure_of(drawing(nested("g", 100'000, "<circle r='3'/>"))).find("deep") != std::string::npos);
    CHECK(failure_of("<s:svg xmlns:s='http://www.w3.org/2000/svg'>" + nested("s:g", 100'000, "") + "</s:svg>")
              .find("deep") != std::string::npos);
    CHECK(failure_of(drawing(nested("defs", 100'000, ""))).empty());
    CHECK(failure_of(drawing(nested("text", 100'000, "a"))).empty());
}

TEST_CASE("a style sheet that would take for ever is refused")
{
    std::string css = "<style>";
    for (int i = 0; i < 9000; ++i)
        css += ".c" + std::to_string(i) + " .d .e{fill:red}";
    css += "</style>";
    for (int i = 0; i < 5000; ++i)
        css += "<g/>";
    CHECK(failure_of(drawing(css)).find("too many rules") != std::string::npos);
}

TEST_CASE("selectors of many classes for elements of many classes are refused")
{
    std::string css = "<style>z";
    for (int compound = 0; compound < 6; ++compound) {
        css += ' ';
        for (int i = 0; i < 1500; ++i)
            css += ".a";
    }
    css += " rect{fill:red}</style>";
    std::string classes;
    for (int i = 0; i < 1500; ++i)
        classes += "b ";
    std::string text = css;
    for (int depth = 0; depth < 40; ++depth)
        text += "<g class='" + classes + "a'>";
    for (int i = 0; i < 1000; ++i)
        text += "<rect width='9' height='9'/>";
    for (int depth = 0; depth < 40; ++depth)
        text += "</g>";
    CHECK(failure_of(drawing(text)).find("too many rules") != std::string::npos);
}

TEST_CASE("a file of many rules and many elements is read")
{
    std::string text = "<style>";
    for (int i = 0; i < 2000; ++i)
        text += ".class-of-number-" + std::to_string(i) + "{fill:red}";
    text += "</style>";
    for (int i = 0; i < 5000; ++i)
        text += "<g class='class-of-number-7 another-class and-one-more-of-them'/>";
    CHECK(failure_of(drawing(text)).empty());
}

TEST_CASE("long styles are not copied without bounds")
{
    std::string text = "<path id='p' d='" + std::string(1'000'000, ' ') + "'/>";
    for (int i = 0; i < 1000; ++i)
        text += "<use href='#p'/>";
    CHECK(failure_of(drawing(text)).find("512 MB") != std::string::npos);
    const std::string long_name(100'000, 'x');
    art::Losses losses;
    const auto document = svg::read_svg(
        {"test.svg", drawing("<circle r='3' id='" + long_name + "' " + long_name + "='1'/>")}, losses);
    CHECK(document.nodes.front().name.size() < 300);
    CHECK(losses.list().front().feature.size() < 100);
}

TEST_CASE("rules in rules in rules end somewhere")
{
    std::string css;
    for (int i = 0; i < 20'000; ++i)
        css += "@media screen{";
    CHECK(failure_of(drawing("<style>" + css + "</style>")).empty());
    std::string selectors = "a";
    for (int i = 0; i < 20'000; ++i)
        selectors += ",a";
    CHECK(failure_of(drawing("<style>" + selectors + "{fill:red}</style>")).find("10000 rules") !=
          std::string::npos);
}

TEST_CASE("entities do not grow without bounds")
{
    std::string text = "<!DOCTYPE svg [<!ENTITY a \"" + std::string(100'000, 'x') + "\">\n]><svg><desc>";
    for (int i = 0; i < 1000; ++i)
        text += "&a;";
    CHECK(failure_of(text + "</desc></svg>").find("64 MB") != std::string::npos);
    CHECK(
        failure_of("<!DOCTYPE svg [<!ENTITY a \"&b;&b;\"><!ENTITY b \"&a;&a;\">]><svg><desc>&a;</desc></svg>")
            .empty());
    CHECK(failure_of("<!DOCTYPE svg [<!ENTITY a \"").empty() == false);
}

TEST_CASE("dashes do not grow without bounds")
{
    CHECK(
        losses_of("<path d='M0 0H9e6' stroke='red' stroke-dasharray='1' transform='scale(.001)'/>").size() ==
        1);
    CHECK(failure_of(drawing("<path d='M0 0H9e6' stroke='red' stroke-dasharray='1'/>")).find("points") !=
          std::string::npos);
}

TEST_CASE("numbers out of all proportion give a scene of finite ones")
{
    art::Losses losses;
    const auto document = svg::read_svg(
        {"test.svg",
         drawing(
             "<g transform='scale(1e300)'><g transform='scale(1e300)'><circle r='3'/></g></g>"
             "<circle r='3' stroke='red' stroke-width='1e300'/><rect width='1e300' height='3'/>"
             "<path d='M0 0H1e308'/><svg y='1e300' width='9' height='9'><circle r='30'/></svg>"
             "<clipPath id='c'><rect x='1e300' width='1e300' height='9' transform='scale(1e300)'/></clipPath>"
             "<circle r='3' clip-path='url(#c)'/>",
             "width='1e300' height='3' viewBox='0 0 1e-300 1e-300'")},
        losses);
    CHECK(document.width <= 1e5);
    for (const art::Node& node : document.nodes)
        for (const double coordinate : box(std::get<art::Shape>(node.content).drawing.value()))
            CHECK(std::isfinite(coordinate));
}

TEST_CASE("key drawings need times that rise")
{
    CHECK(keys_failure(2, {0, 12}).empty());
    CHECK(keys_failure(2, {0}) == "2 key drawings but 1 times: name a time for each of them");
    CHECK_FALSE(keys_failure(0, {}).empty());
    CHECK_FALSE(keys_failure(2, {0, 0}).empty());
    CHECK_FALSE(keys_failure(2, {12, 6}).empty());
    CHECK_FALSE(keys_failure(2, {-1, 6}).empty());
    CHECK_FALSE(keys_failure(2, {0, std::nan("")}).empty());
}
