#include "host/import/import_scene.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <string>
#include <utility>
#include <vector>

namespace kfast::test {
namespace {

std::string animation(const std::string& layers)
{
    return R"({"w": 100, "h": 80, "fr": 30, "ip": 0, "op": 60, "assets": [{"id": "c", "layers": [{"ty": 1,
        "nm": "box", "sw": 20, "sh": 10, "sc": "#ff8000", "ip": 0, "op": 60,
        "ks": {"r": {"k": [{"t": 0, "s": [0]}, {"t": 5, "s": [90]}, {"t": 9, "s": [0]}]}}}]}], "layers": [)" +
           layers + "]}";
}

std::string used(const std::string& more)
{
    return R"({"ty": 0, "nm": "comp", "refId": "c", "ip": 0, "op": 60, )" + more + "}";
}

const std::string looping =
    used(R"("tm": {"k": [{"t": 0, "s": [0]}, {"t": 10, "s": [0.333]}], "x": "$bm_rt = loopOut('cycle');"})");

bool has_symbol(const std::string& layers)
{
    const std::string text = importing::import_scene("a.json", animation(layers), {}).text;
    return text.find("\nsymbol ") != std::string::npos;
}

}

TEST_CASE("what is repeated is a symbol, unless the scene is smaller without")
{
    CHECK(has_symbol(looping));
    CHECK(has_symbol(used(R"("st": 0)") + "," + used(R"("st": 0)") + "," + used(R"("st": 0)")));
    CHECK(!has_symbol(used(R"("st": 0)") + "," + used(R"("st": 7)")));
}

TEST_CASE("more different times than a scene has are written out")
{
    std::string layers = looping;
    for (int i = 0; i < 230; ++i)
        layers += "," + used(R"("ks": {"o": {"k": 50}}, "st": )" + std::to_string(i / 5.0));
    CHECK(!has_symbol(layers));
}

TEST_CASE("an import in both ways tells how far it has come, too")
{
    std::vector<std::pair<std::size_t, std::size_t>> progress;
    importing::Options options;
    options.on_progress = [&](std::size_t done, std::size_t total) { progress.emplace_back(done, total); };
    importing::import_scene("a.json", animation(looping), options);
    CHECK(std::ranges::is_sorted(progress));
    CHECK(progress.back().first > progress.back().second * 9 / 10);
    CHECK(std::ranges::all_of(progress, [&](const auto& step) { return step.second == progress[0].second; }));
}

}
