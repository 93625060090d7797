#include "tests/host/lottie/lottie_text.hpp"

#include "host/program/failure.hpp"

#include <doctest/doctest.h>

namespace kfast::lottie {

std::string animation_text(const std::string& layers, const std::string& more)
{
    return R"({"w": 100, "h": 80, "fr": 30, "ip": 0, "op": 60, )" + more + R"("layers": [)" + layers + "]}";
}

art::Document read_with(const std::string& text, art::Losses& losses)
{
    return read_lottie({"a.json", text}, losses);
}

art::Document read_whole(const std::string& text)
{
    art::Losses losses;
    art::Document document = read_with(text, losses);
    for (const art::Loss& loss : losses.list())
        FAIL_CHECK(loss.layer, ": ", loss.feature, ", ", loss.instead);
    return document;
}

art::Document read_written_out(const std::string& text)
{
    art::Losses losses;
    return read_lottie({"a.json", text}, losses, Repeated::written_out);
}

std::string failure_of(const std::string& text, Repeated repeated)
{
    try {
        art::Losses losses;
        read_lottie({"a.json", text}, losses, repeated);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return {};
}

std::string solid(const std::string& more, const char* name)
{
    return R"({"ty": 1, "sw": 20, "sh": 10, "sc": "#ff8000", "ip": 0, "op": 60, )" + more + R"("nm": ")" +
           name + "\"}";
}

const art::Group& group_of(const art::Node& node)
{
    REQUIRE(std::holds_alternative<art::Group>(node.content));
    return std::get<art::Group>(node.content);
}

const art::Shape& shape_of(const art::Node& node)
{
    REQUIRE(std::holds_alternative<art::Shape>(node.content));
    return std::get<art::Shape>(node.content);
}

}
