#include "host/compiler/drifting_arcs.hpp"

#include "host/compiler/compile.hpp"

#include <doctest/doctest.h>

#include <string>

namespace kfast::test {
namespace {

/// The warnings for one object.
std::string warnings(const std::string& keys, const std::string& object = "stroke=red",
                     const std::string& range = "min=-50 max=4095")
{
    const std::string text = "kfast 1\ncanvas 240 240 frames=3000\ninput v " + range + "\nobject o " +
                             object + " { " + keys +
                             " }\nobject user fill=red input=v { key 0 { circle 9 9 r=1 } }\n";
    Diagnostics diagnostics;
    compile({"s.kfast", text}, diagnostics);
    std::string all;
    for (const Diagnostic& finding : diagnostics.sorted())
        all += finding.message + " (" + finding.hint + ")\n";
    return all;
}

/// Not alone, for then it would be trimmed.
std::string arc(double from, double to)
{
    return "arc 120 120 r=95 from=" + std::to_string(from) + " to=" + std::to_string(to) +
           "; line 120 119 120 121";
}

bool drifts(const std::string& keys, const std::string& object = "stroke=red")
{
    return warnings(keys, object).starts_with("the arc leaves its circle");
}

}

TEST_CASE("an arc that grows by a quarter turn from key to key leaves its circle by the height of its chord")
{
    // The end goes along a chord of 90 degrees: half way it is 95 (1 - cos 45°) = 27.8 px inside.
    const std::string found = warnings("key 0 { " + arc(0, 90) + " }; key 100 { " + arc(0, 180) + " }");
    CHECK(found.starts_with("the arc leaves its circle on the way to the next key, by 2"));
    CHECK(found.find(" px at frame ") != std::string::npos);
    CHECK(
        found.ends_with(": points go straight (draw it in an object of its own, where its ends go along the "
                        "circle)\n"));
}

TEST_CASE("keys as near as the warning says, or an arc that only moves and grows, are good")
{
    CHECK(warnings("key 0 { " + arc(0, 90) + " }; key 100 { " + arc(0, 100) + " }") == "");
    CHECK(drifts("key 0 { " + arc(0, 90) + " }; key 100 { " + arc(0, 115) + " }"));
    CHECK(warnings("key 0 { arc 90 90 r=9 from=0 to=200 }; key 100 { arc 99 120 r=80 from=0 to=200 }") == "");
    CHECK(warnings("key 0 { circle 90 90 r=9 }; key 100 { circle 120 90 r=80 }") == "");
}

TEST_CASE("an arc of a circle that is alone in its object is trimmed and stays on it")
{
    const std::string ends = " from=0 to=90 }; key 100 { arc 120 120 ";
    CHECK(warnings("key 0 { arc 120 120 r=95" + ends + "r=95 from=0 to=270 }") == "");
    const std::string bent =
        warnings("key 0 { arc 120 120 rx=95 ry=60" + ends + "rx=95 ry=60 from=0 to=270 }");
    CHECK(bent.find("add a key for every 11 degrees") != std::string::npos);
}

TEST_CASE("as many keys as the warning says keep an arc on its circle all the way round")
{
    std::string keys;
    for (int i = 0; i < 27; ++i)
        keys += "key " + std::to_string(3 * i) + " match=length { " + arc(135, 136 + 10 * i) + " }; ";
    CHECK(warnings(keys + "key 81 { " + arc(135, 406) + " }") == "");
}

TEST_CASE("pies and pieces of rings are looked at as well")
{
    CHECK(drifts("key 0 { pie 99 99 r=50 from=0 to=60; line 1 1 9 9 }; "
                 "key 100 { pie 99 99 r=50 from=0 to=160; line 1 1 9 9 }"));
    CHECK(drifts(
        "key 0 { pie 99 99 r=50 from=0 to=60 inner=30 }; key 100 { pie 99 99 r=50 from=0 to=160 inner=30 }"));
    CHECK(drifts("key 0 { line 1 1 9 9; " + arc(0, 9) + " }; key 100 { line 1 1 9 9; " + arc(90, 99) + " }"));
    CHECK(drifts("key 0 match=length { " + arc(0, 90) + " }; key 100 { " + arc(0, 180) + " }"));
}

TEST_CASE("what is not seen between two keys is no drift")
{
    const std::string ends = "{ " + arc(0, 90) + " }; key 100 { " + arc(0, 180) + " }";
    CHECK(warnings("key 0 law=hold " + ends) == "");
    CHECK(warnings("key 0 law=\"steps(1)\" " + ends) == "");
    CHECK(drifts("key 0 law=\"steps(3)\" " + ends));
    CHECK(warnings("key 0 { " + arc(0, 90) + " }; key 1 { " + arc(0, 180) + " }") == "");
}

TEST_CASE("the worst of all ways is named, at a frame or a value of the input")
{
    const std::string keys =
        "key 0 { " + arc(0, 90) + " }; key 50 { " + arc(0, 110) + " }; key 52 { " + arc(0, 200) + " }";
    CHECK(warnings(keys).find("px at frame 51:") != std::string::npos);
    CHECK(warnings("key 0 { " + arc(0, 90) + " }; key 100 { " + arc(0, 180) + " }", "stroke=red input=v")
              .find("px at v=") != std::string::npos);
}

TEST_CASE("a moment from 1000 on is written in full")
{
    CHECK(warnings("key 2900 { " + arc(0, 90) + " }; key 2902 { " + arc(0, 180) + " }")
              .find(" px at frame 2901:") != std::string::npos);
}

TEST_CASE("a value of an input is rounded as its range asks for")
{
    const auto at_value = [](const std::string& last, const std::string& range) {
        const std::string found =
            warnings("key 0 { " + arc(0, 90) + " }; key " + last + " { " + arc(0, 180) + " }",
                     "stroke=red input=v", range);
        const std::size_t begin = found.find(" px at ") + 7;
        return found.substr(begin, found.find(':', begin) - begin);
    };
    CHECK(at_value("4095", "min=-50 max=4095") == "v=1911");
    CHECK(at_value("100", "min=0 max=100") == "v=46.7");
    CHECK(at_value("1", "min=0 max=1") == "v=0.467");
}

}
