#include "tests/host/lottie/lottie_text.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::lottie;

TEST_CASE("a text that is no JSON is refused at its line and column")
{
    CHECK(failure_of("{\n  \"w\": 1,\n  oops\n}").starts_with("a.json:3:3: this is no JSON: "));
    CHECK(failure_of("").starts_with("a.json:1:1: "));
    CHECK(failure_of("{\"w\": \"\xff\"}").starts_with("a.json:1:"));
    CHECK(failure_of(R"({"w": 1e999})").find("too large") != std::string::npos);
}

TEST_CASE("a text that is too deep is refused before it takes any memory")
{
    CHECK(failure_of(std::string(3'000'000, '['))
              .starts_with("a.json:1:257: lists and objects lie more than 256 deep"));
    CHECK(failure_of(R"({"a": ")" + std::string(1000, '[') + "\"}").find("deep") == std::string::npos);
}

TEST_CASE("a text of too many values is refused before they take any memory")
{
    std::string values(2 * 2'097'149, ',');
    for (std::size_t i = 0; i < values.size(); i += 2)
        values[i] = '0';
    values.back() = ']';
    const std::string too_many = "a.json: more than 2097152 values of JSON: take something out of the file";
    CHECK(failure_of(R"({"a": 1, "b": [)" + values + "}") != too_many);
    CHECK(failure_of(R"({"a": 1, "b": [0,)" + values + "}") == too_many);
}

TEST_CASE("what is missing or of another kind is refused by its path")
{
    CHECK(failure_of("[]") == "a.json: this is no animation of Lottie: it has no \"layers\"");
    CHECK(failure_of(R"({"w": 1, "h": 1, "fr": 30, "layers": []})") ==
          "a.json: \"op\" is missing: export the file again");
    CHECK(failure_of(R"({"w": "1", "h": 1, "fr": 30, "op": 1, "layers": []})") ==
          "a.json: w: is a text instead of a number: take the quotes away");
    CHECK(failure_of(R"({"w": 0, "h": 1, "fr": 30, "op": 1, "layers": []})") == "a.json: w: is not above 0");
    CHECK(failure_of(animation_text("3")) == "a.json: layers[0]: is no layer: one is an object");
    CHECK(failure_of(animation_text(solid(R"("ks": {"p": {"k": [1, "2"]}}, )"))) ==
          "a.json: layers[0].ks.p.k[1]: is a text instead of a number: take the quotes away");
    CHECK(failure_of(animation_text(solid(R"("ks": {"r": {"k": [{"t": 1}]}}, )"))) ==
          "a.json: layers[0].ks.r.k[0]: \"s\" is missing: the first key needs a value");
    CHECK(failure_of(animation_text(R"({"ty": 4, "shapes": 5, "ip": 0, "op": 60})")) ==
          "a.json: layers[0].shapes: is a number instead of a list");
}

TEST_CASE("a length that is none, or too long, is refused")
{
    const auto lasting = [](const char* end) {
        return R"({"w": 1, "h": 1, "fr": 30, "ip": 5, "op": )" + std::string{end} + R"(, "layers": []})";
    };
    CHECK(failure_of(lasting("5")) != "");
    CHECK(failure_of(lasting("2000000")) != "");
    CHECK(failure_of(lasting("5.25")) == "");
}

TEST_CASE("times that are stretched beyond all measure are refused, or end")
{
    const auto comps = [](const std::string& outer, const std::string& inner, const std::string& shape) {
        return animation_text(
            R"({"ty": 0, "refId": "a", "ip": 0, "op": 60)" + outer + "}",
            R"("assets": [{"id": "a", "layers": [{"ty": 0, "refId": "b", "ip": 0, "op": 1e9)" + inner +
                R"(}]}, {"id": "b", "layers": [{"ty": 4, "ip": 0, "op": 1e9, )" +
                R"("shapes": [{"ty": "el", "s": {"k": [9, 9]}, "p": {"k": [0, 0]}}, )" + shape +
                R"({"ty": "fl", "c": {"k": [1, 0, 0]}}]}]}], )");
    };
    CHECK(failure_of(comps(R"(, "sr": 100)", R"(, "sr": 100)", "")).find("too far from 1") !=
          std::string::npos);
    const auto eased = [](const char* time, const char* seconds) {
        return R"(, "tm": {"k": [{"t": 0, "s": [0], "o": {"x": 0.5, "y": 0}, "i": {"x": 0.5, "y": 1}}, {"t": )" +
               std::string{time} + R"(, "s": [)" + seconds + "]}]}";
    };
    CHECK(failure_of(comps(eased("60", "1e6"), eased("1e9", "1e9"), "")).find("keys") != std::string::npos);
    CHECK(failure_of(comps(
              R"(, "sr": 1000)", "",
              R"({"ty": "rp", "c": {"k": [{"t": 999999999.9, "s": [1]}, {"t": 1e9, "s": [3]}]}}, )")) == "");
}

TEST_CASE("more keys than there may be are refused")
{
    std::string keys;
    for (int i = 0; i < 2000; ++i)
        keys += (i == 0 ? "" : ",") + std::string{R"({"t":1,"s":1})"};
    std::string layers;
    for (int i = 0; i < 300; ++i)
        layers += (i == 0 ? "" : ",") + std::string{R"({"ty": 0, "ip": 0, "op": 60, "refId": "c"})"};
    const std::string text = animation_text(
        layers, R"("assets": [{"id": "c", "layers": [)" +
                    solid(R"("ks": {"r": {"k": [)" + keys + "]}, \"s\": {\"k\": [" + keys + "]}}, ") +
                    "]}], ");
    CHECK(failure_of(text, Repeated::written_out).find("more than 1048576 keys") != std::string::npos);
    CHECK(failure_of(text) == "");
}

TEST_CASE("repeaters of repeaters over what is trimmed at every moment are refused")
{
    const std::string repeater =
        R"(, {"ty": "rp", "c": {"k": 100}, "o": {"k": 0}, "tr": {"p": {"k": [1, 0]}}})";
    CHECK(failure_of(animation_text(
                         R"({"ty": 4, "ip": 0, "op": 60, "shapes": [{"ty": "el", "p": {"k": [50, 40]}, )"
                         R"("s": {"a": 1, "k": [{"t": 0, "s": [10, 10]}, {"t": 60, "s": [30, 10]}]}}, )"
                         R"({"ty": "tm", "s": {"a": 1, "k": [{"t": 0, "s": [0]}, {"t": 59, "s": [90]}]}, )"
                         R"("e": {"k": 100}, "o": {"k": 0}}, )"
                         R"({"ty": "fl", "c": {"k": [1, 0, 0]}, "o": {"k": 100}})" +
                         repeater + repeater + "]}"),
                     Repeated::written_out)
              .find("points to compute") != std::string::npos);
}
