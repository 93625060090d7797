#include "tests/host/lottie/lottie_text.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::lottie;

namespace {

/// The features that are lost, one after the other.
std::string lost(const std::string& text)
{
    art::Losses losses;
    read_with(text, losses);
    std::string features;
    for (const art::Loss& loss : losses.list()) {
        CHECK_FALSE(loss.instead.empty());
        features += (features.empty() ? "" : "; ") + loss.layer + ": " + loss.feature;
    }
    return features;
}

std::string lost_layer(const std::string& more)
{
    return lost(animation_text("{" + more + R"("nm": "l", "ip": 0, "op": 60})"));
}

}

TEST_CASE("layers that cannot be drawn are reported")
{
    CHECK(lost_layer(R"("ty": 5, "t": {"d": {"k": [{"t": 0, "s": {"t": "Hello"}}]}}, )") ==
          "l: text \"Hello\"");
    CHECK(lost_layer(R"("ty": 5, )") == "l: text");
    CHECK(lost_layer(R"("ty": 6, )") == "l: sound");
    CHECK(lost_layer(R"("ty": 12, )") == "l: adjustment layer");
    CHECK(lost_layer(R"("ty": 99, )") == "l: layer of the type 99");
    CHECK(lost_layer(R"("ty": 3, )") == "");
    CHECK(lost(animation_text(R"({"ty": 2, "nm": "l", "refId": "i", "ip": 0, "op": 60})",
                              R"("assets": [{"id": "i", "p": "cat.png"}], )")) == "l: image \"cat.png\"");
}

TEST_CASE("what a layer has besides is reported where it is")
{
    CHECK(lost(animation_text(solid(R"("bm": 1, )"))) == "box: blend mode multiply");
    CHECK(lost(animation_text(solid(R"("bm": 77, )"))) == "box: blend mode 77");
    CHECK(lost(animation_text(solid(R"("mb": true, )"))) == "box: motion blur");
    CHECK(lost(animation_text(solid(R"("ef": [{"nm": "Drop Shadow", "ty": 25}, {"nm": "off", "en": 0},
        {"nm": "Size", "mn": "ADBE Slider Control"}], )"))) == "box: effect \"Drop Shadow\"");
    CHECK(lost(animation_text(solid(R"("sy": [{"nm": "Glow"}], )"))) == "box: layer style \"Glow\"");
    CHECK(lost(animation_text(solid(R"("parent": 9, )"))) == "box: parent 9");
    CHECK(lost(animation_text(solid(R"("sparkle": 9, )"))) == "box: member \"sparkle\"");
    CHECK(lost(animation_text(solid(R"("ks": {"r": {"k": 3, "x": "var $bm_rt = wiggle(1, 2);"}}, )"))) ==
          "box: expression of ks.r");
}

TEST_CASE("a slot keeps the value that stands beside it")
{
    const std::string text = solid(R"("ks": {"r": {"k": 3, "sid": "lean"}}, )");
    CHECK(lost(animation_text(text, R"("slots": {"lean": {"p": {"k": 40}}}, )")) ==
          "box: slot \"lean\" of ks.r");
}

TEST_CASE("layers in a precomposition are named with what they are in")
{
    CHECK(lost(animation_text(R"({"ty": 0, "nm": "comp", "refId": "c", "ip": 0, "op": 60})",
                              R"("assets": [{"id": "c", "layers": [)" + solid(R"("bm": 1, )") + "]}], ")) ==
          "comp / box: blend mode multiply");
    CHECK(lost(animation_text(R"({"ty": 12, "ip": 0, "op": 60})")) == "layer 1: adjustment layer");
}

TEST_CASE("an expression of a parent that is not drawn is reported as well")
{
    CHECK(
        lost(animation_text(solid(R"("parent": 2, )") +
                            R"(,{"ty": 3, "ind": 2, "nm": "n", "ks": {"p": {"k": [1, 2], "x": "wiggle(2, 9);"
}
}
})")) == "n: expression of ks.p");
}
